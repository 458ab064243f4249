// An interrupted evaluation continues from its kept parts and gives the same figures.
#include <gtest/gtest.h>

#include "evaluate/error_archive.hpp"
#include "foramen/core/error.hpp"
#include "foramen/evaluate/evaluate.hpp"
#include "support/memory_store.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

std::string bytes_of(const Evaluation& e) {
  ByteWriter bytes;
  for (const auto* by_modes :
       {&e.leave_one_out.by_modes, &e.leave_subject_out->by_modes, &e.specificity.by_modes})
    for (const ErrorsAtModes& errors : *by_modes) bytes(errors.modes, errors.items);
  bytes(e.specificity.nearest_draw);
  return bytes.take();
}

TEST(ResumedEvaluation, HasTheSameFiguresWhereverItWasStopped) {
  const CorrespondingCohort cohort = testing::torus_cohort();
  EvaluationOptions options;
  options.draws = 12;
  options.samples = 300;
  options.specificity_samples = 200;
  const std::string undisturbed = bytes_of(evaluate(cohort, options, RunContext(2)));
  constexpr int parts = 5 + 5 + 3;  // shapes, shapes by subject, blocks of five draws
  for (const int stop_at : {1, 7, 11, 12}) {
    const auto store = std::make_shared<testing::MemoryStore>();
    const RunContext first = RunContext(1).with_store(store);
    store->stop(first, stop_at);
    EXPECT_THROW(evaluate(cohort, options, first), Cancelled);
    const RunContext second = RunContext(2).with_store(store);
    EXPECT_EQ(bytes_of(evaluate(cohort, options, second)), undisturbed) << stop_at;
    EXPECT_EQ(store->loads, stop_at);
    EXPECT_EQ(store->kept_twice, 0);
    EXPECT_EQ(store->size(), parts);
  }
}

}  // namespace
}  // namespace foramen
