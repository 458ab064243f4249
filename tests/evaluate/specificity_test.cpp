#include "foramen/evaluate/specificity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "foramen/core/error.hpp"
#include "foramen/evaluate/specificity.hpp"
#include "foramen/spatial/surface_distance.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

const SpecificityOptions few{.draws = 12, .seed = 3, .surface_samples = 200};

AlignedCohort cohort(int shapes = 6) {
  return align_cohort(testing::torus_cohort({.shapes = shapes}), ScaleMode::keep);
}

std::vector<double> flat(const Specificity& s) {
  std::vector<double> numbers;
  for (const ErrorsAtModes& e : s.by_modes)
    for (const ShapeError& item : e.items)
      numbers.insert(numbers.end(), {item.hausdorff, item.mean_surface, item.landmark_rms});
  for (const auto& nearest : s.nearest_draw) numbers.insert(numbers.end(), nearest.begin(), nearest.end());
  return numbers;
}

void compare_with_all(const AlignedCohort& aligned) {
  const int last = 5;
  const Specificity found = specificity(aligned, last, few, RunContext(2));
  std::vector<TriangleTree> inputs;
  for (const Mesh& m : aligned.inputs) inputs.emplace_back(m);
  ASSERT_EQ(found.by_modes.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    ASSERT_EQ(found.by_modes[k].items.size(), 12u);
    std::vector<double> nearest(inputs.size(), std::numeric_limits<double>::infinity());
    for (int draw = 0; draw < few.draws; ++draw) {
      Rng rng = Rng(few.seed).fork(static_cast<std::uint64_t>(draw));
      const Eigen::VectorXd b = aligned.model.draw(rng).head(static_cast<Eigen::Index>(k) + 1);
      const Eigen::VectorXd x = aligned.model.reconstruct(b);
      const TriangleTree tree(build_mesh({unflattened(x), aligned.model.triangles()}));
      ShapeError expected{1e300, 1e300, 1e300};
      for (std::size_t i = 0; i < inputs.size(); ++i) {
        const SurfaceDistance d = surface_distance(tree, inputs[i], {.samples = 200, .seed = few.seed});
        const double rms = aligned.model.landmark_rms(flattened(aligned.alignment.aligned[i]), x);
        expected.hausdorff = std::min(expected.hausdorff, d.hausdorff);
        expected.mean_surface = std::min(expected.mean_surface, d.mean);
        expected.landmark_rms = std::min(expected.landmark_rms, rms);
        nearest[i] = std::min(nearest[i], d.hausdorff);
      }
      const ShapeError& item = found.by_modes[k].items[draw];
      EXPECT_NEAR(item.hausdorff, expected.hausdorff, 1e-12);
      EXPECT_NEAR(item.mean_surface, expected.mean_surface, 1e-12);
      EXPECT_NEAR(item.landmark_rms, expected.landmark_rms, 1e-12);
    }
    for (std::size_t i = 0; i < inputs.size(); ++i) EXPECT_NEAR(found.nearest_draw[k][i], nearest[i], 1e-12);
  }
}

TEST(Specificity, IsWhatComparingEveryDrawWithEveryShapeGives) { compare_with_all(cohort()); }

TEST(Specificity, TheSameWithWeightedLandmarks) {
  compare_with_all(
      align_cohort(testing::torus_cohort({.shapes = 6}), ScaleMode::keep, LandmarkWeights::area));
}

TEST(Specificity, EstimatesAreOverDraws) {
  const Specificity s = specificity(cohort(4), 3, few, RunContext(1));
  double sum = 0, squares = 0;
  const auto& items = s.by_modes[2].items;
  for (const ShapeError& e : items) sum += e.hausdorff / 12;
  for (const ShapeError& e : items) squares += (e.hausdorff - sum) * (e.hausdorff - sum);
  EXPECT_NEAR(s.by_modes[2].hausdorff.mean, sum, 1e-12);
  EXPECT_NEAR(s.by_modes[2].hausdorff.standard_error, std::sqrt(squares / 11) / std::sqrt(12), 1e-12);
}

TEST(Specificity, ThreadsAndRepetitionChangeNothing) {
  const AlignedCohort aligned = cohort(5);
  const auto one = flat(specificity(aligned, 4, few, RunContext(1)));
  EXPECT_EQ(one, flat(specificity(aligned, 4, few, RunContext(1))));
  EXPECT_EQ(one, flat(specificity(aligned, 4, few, RunContext(2))));
  EXPECT_EQ(one, flat(specificity(aligned, 4, few, RunContext(5))));
}

TEST(Specificity, DrawsDoNotDependOnTheirNumberOrOnTheDistancesAsked) {
  const AlignedCohort aligned = cohort(5);
  SpecificityOptions fewer = few, mean_only = few;
  fewer.draws = 4;
  mean_only.hausdorff = false;
  const Specificity all = specificity(aligned, 3, few, RunContext(2));
  const Specificity some = specificity(aligned, 3, fewer, RunContext(2));
  const Specificity means = specificity(aligned, 3, mean_only, RunContext(2));
  for (std::size_t draw = 0; draw < 4; ++draw) {
    EXPECT_EQ(all.by_modes[2].items[draw].hausdorff, some.by_modes[2].items[draw].hausdorff);
    EXPECT_EQ(all.by_modes[2].items[draw].mean_surface, some.by_modes[2].items[draw].mean_surface);
  }
  for (std::size_t draw = 0; draw < 12; ++draw) {
    EXPECT_EQ(all.by_modes[1].items[draw].mean_surface, means.by_modes[1].items[draw].mean_surface);
    EXPECT_EQ(means.by_modes[1].items[draw].hausdorff, 0);
  }
  EXPECT_TRUE(means.nearest_draw.empty());
}

TEST(Specificity, IdenticalShapesAreMetExactly) {
  CorrespondingCohort same = testing::torus_cohort({.shapes = 1});
  for (int s = 0; s < 3; ++s) {
    same.corresponding.push_back(same.corresponding[0]);
    same.inputs.push_back(same.inputs[0]);
    same.names.push_back("copy");
    same.subjects.push_back("copy");
  }
  for (auto& m : same.inputs) m = build_mesh({same.corresponding[0], same.triangles});
  const Specificity s = specificity(align_cohort(same, ScaleMode::keep), 3, few, RunContext(1));
  for (const ErrorsAtModes& e : s.by_modes) {
    EXPECT_LT(e.hausdorff.mean, 1e-12);
    EXPECT_LT(e.mean_surface.mean, 1e-12);
    EXPECT_LT(e.landmark_rms.mean, 1e-12);
  }
}

TEST(Specificity, AnotherUnitScalesTheNumbersAndCostsNoMore) {
  const CorrespondingCohort in_mm = testing::torus_cohort({.shapes = 4});
  const auto of = [](const CorrespondingCohort& shapes) {
    return flat(specificity(align_cohort(shapes, ScaleMode::keep), 3, few, RunContext(2)));
  };
  const std::vector<double> expected = of(in_mm);
  for (const double unit : {1e-3, 1e3}) {
    CorrespondingCohort scaled = in_mm;
    for (auto& points : scaled.corresponding)
      for (Vec3& p : points) p *= unit;
    for (Mesh& mesh : scaled.inputs) {
      TriangleSoup soup = mesh.soup();
      for (Vec3& p : soup.points) p *= unit;
      mesh = build_mesh(std::move(soup));
    }
    const std::vector<double> found = of(scaled);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i] / unit, expected[i], 1e-9);
  }
}

TEST(Ensemble, IsTheMeanOfTheSmallestDistancesEitherWay) {
  const Specificity s = specificity(cohort(5), 4, few, RunContext(1));
  const auto ensemble = ensemble_form(s);
  ASSERT_EQ(ensemble.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    double sum = 0;
    for (const double d : s.nearest_draw[k]) sum += d;
    EXPECT_EQ(ensemble[k].modes, static_cast<int>(k) + 1);
    EXPECT_NEAR(ensemble[k].generalization.mean, sum / 5, 1e-12);
    EXPECT_EQ(ensemble[k].specificity.mean, s.by_modes[k].hausdorff.mean);
    EXPECT_EQ(ensemble[k].specificity.standard_error, s.by_modes[k].hausdorff.standard_error);
  }
}

TEST(Specificity, RefusesNothingToDo) {
  const AlignedCohort aligned = cohort(3);
  EXPECT_THROW(specificity(aligned, 2, {.draws = 0}, RunContext(1)), InvalidInput);
  EXPECT_THROW(specificity(aligned, 2, {.surface_samples = 0}, RunContext(1)), InvalidInput);
}

TEST(Specificity, StopsWhenAsked) {
  const RunContext ctx(1);
  ctx.request_stop();
  EXPECT_THROW(specificity(cohort(3), 2, few, ctx), Cancelled);
}

}  // namespace
}  // namespace foramen
