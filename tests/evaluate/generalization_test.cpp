#include "foramen/evaluate/generalization.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "foramen/core/error.hpp"
#include "foramen/spatial/surface_distance.hpp"
#include "support/heap_in_use.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

using testing::torus_cohort;

const GeneralizationOptions by_shape{.samples = 300, .seed = 2};
const GeneralizationOptions by_subject{.leave_out = LeaveOut::subject, .samples = 300, .seed = 2};

std::vector<double> flat(const Generalization& g) {
  std::vector<double> numbers;
  for (const ErrorsAtModes& e : g.by_modes)
    for (const ShapeError& item : e.items)
      numbers.insert(numbers.end(), {item.hausdorff, item.mean_surface, item.landmark_rms});
  return numbers;
}

/// The error of one shape and a model of the others, computed step by step from its definition.
ShapeError by_definition(const CorrespondingCohort& cohort, std::size_t shape,
                         const std::vector<std::size_t>& others, int modes, ScaleMode scale,
                         const std::vector<double>& weights = {}) {
  std::vector<std::vector<Vec3>> training;
  for (const std::size_t o : others) training.push_back(cohort.corresponding[o]);
  const ProcrustesResult aligned = procrustes(training, scale, weights);
  const ShapeModel model = model_of_aligned(aligned.aligned, cohort.triangles, weights);
  const SimilarityTransform motion = align_to_mean(cohort.corresponding[shape], aligned, scale, weights);
  std::vector<Vec3> moved;
  for (const Vec3& p : cohort.corresponding[shape]) moved.push_back(motion(p));
  const Eigen::VectorXd x = flattened(moved), fit = model.reconstruct(model.scores(x, modes));
  const SurfaceDistance d =
      surface_distance(TriangleTree(build_mesh({unflattened(fit), cohort.triangles})),
                       TriangleTree(transformed(cohort.inputs[shape], motion)), {.samples = 300, .seed = 2});
  return {d.hausdorff, d.mean, model.landmark_rms(fit, x)};
}

void expect_same(const ShapeError& a, const ShapeError& b) {
  EXPECT_NEAR(a.hausdorff, b.hausdorff, 1e-12);
  EXPECT_NEAR(a.mean_surface, b.mean_surface, 1e-12);
  EXPECT_NEAR(a.landmark_rms, b.landmark_rms, 1e-12);
}

TEST(Generalization, LeavesEachShapeOut) {
  const CorrespondingCohort cohort = torus_cohort({.shapes = 5});
  for (const ScaleMode scale : {ScaleMode::keep, ScaleMode::remove}) {
    GeneralizationOptions options = by_shape;
    options.scale = scale;
    const Generalization g = generalization(cohort, options, RunContext(2));
    EXPECT_EQ(g.groups, 5);
    ASSERT_EQ(g.by_modes.size(), 3u);  // 1 .. n - 2
    for (std::size_t i = 0; i < 5; ++i) {
      std::vector<std::size_t> others;
      for (std::size_t o = 0; o < 5; ++o)
        if (o != i) others.push_back(o);
      for (int m = 1; m <= 3; ++m)
        expect_same(g.by_modes[m - 1].items[i], by_definition(cohort, i, others, m, scale));
    }
  }
}

// There is one model per shape, and each is about as large as all shapes together, so they must not be in
// memory at the same time.
TEST(Generalization, HoldsOneModelAtATime) {
  constexpr int shapes = 24;
  const CorrespondingCohort cohort =
      torus_cohort({.shapes = shapes, .landmark_around = 80, .landmark_tube = 30});
  for (const GeneralizationOptions& options : {by_shape, by_subject}) {
    const double before = testing::heap_in_use();
    double most = 0;
    generalization(cohort, options, RunContext(1, [&](const Progress&) {
                     most = std::max(most, testing::heap_in_use() - before);
                   }));
    // A model consists of aligned shapes and modes.
    const double model = 2.0 * shapes * cohort.landmarks() * sizeof(Vec3);
    EXPECT_LT(most, 4 * model);
  }
}

TEST(Generalization, TakesTheWholeCohortsWeightsWhicheverShapeIsLeftOut) {
  const CorrespondingCohort cohort = torus_cohort({.shapes = 4});
  for (const ScaleMode scale : {ScaleMode::keep, ScaleMode::remove}) {
    const auto weights =
        landmark_weights(cohort.corresponding, cohort.triangles, scale, LandmarkWeights::area);
    GeneralizationOptions options = by_shape;
    options.scale = scale;
    options.weights = LandmarkWeights::area;
    const Generalization g = generalization(cohort, options, RunContext(2));
    const std::vector<std::size_t> without_first{1, 2, 3};
    expect_same(g.by_modes[1].items[0], by_definition(cohort, 0, without_first, 2, scale, weights));
    EXPECT_NE(g.by_modes[1].items[0].landmark_rms,
              by_definition(cohort, 0, without_first, 2, scale).landmark_rms);
  }
}

TEST(Generalization, LeavesEachSubjectOut) {
  CorrespondingCohort cohort = torus_cohort({.shapes = 6});
  cohort.subjects = {"b", "a", "b", "c", "a", "b"};
  const Generalization g = generalization(cohort, by_subject, RunContext(2));
  EXPECT_EQ(g.groups, 3);
  ASSERT_EQ(g.by_modes.size(), 2u);  // without subject b there are 3 shapes, which have 2 modes
  for (std::size_t i = 0; i < 6; ++i) {
    std::vector<std::size_t> others;
    for (std::size_t o = 0; o < 6; ++o)
      if (cohort.subjects[o] != cohort.subjects[i]) others.push_back(o);
    expect_same(g.by_modes[1].items[i], by_definition(cohort, i, others, 2, ScaleMode::keep));
  }
}

TEST(Generalization, LeavingOutASubjectLeavesOutAllItsShapes) {
  // Every subject has two equal shapes. If only one of them is left out, the model still contains its twin;
  // if the subject is left out, it does not.
  CorrespondingCohort cohort = torus_cohort({.shapes = 8});
  for (std::size_t i = 0; i < 8; i += 2) {
    cohort.corresponding[i + 1] = cohort.corresponding[i];
    cohort.inputs[i + 1] = cohort.inputs[i];
    cohort.subjects[i] = cohort.subjects[i + 1] = "pair " + std::to_string(i);
  }
  const Generalization shape = generalization(cohort, by_shape, RunContext(1));
  const Generalization subject = generalization(cohort, by_subject, RunContext(1));
  EXPECT_LT(shape.by_modes[4].landmark_rms.mean, 1e-6);
  EXPECT_GT(subject.by_modes.back().landmark_rms.mean, 0.5);
}

TEST(Generalization, AOneModeFamilyIsDescribedByOneMode) {
  CorrespondingCohort cohort = torus_cohort({.shapes = 6});
  // The shapes are stretched along the axis: x_s = x + s y. They are symmetric, so alignment does not rotate
  // them.
  const TriangleSoup base = testing::torus_soup(20, 8, 30, 10);
  cohort.triangles = base.triangles;
  for (std::size_t s = 0; s < 6; ++s) {
    cohort.corresponding[s] = base.points;
    for (Vec3& p : cohort.corresponding[s]) p.z() *= 1 + 0.1 * static_cast<double>(s);
    cohort.inputs[s] = build_mesh({cohort.corresponding[s], base.triangles});
  }
  const Generalization g = generalization(cohort, by_shape, RunContext(1));
  for (const ErrorsAtModes& e : g.by_modes) {  // includes numbers of modes above the single existing mode
    EXPECT_LT(e.hausdorff.mean, 1e-9);
    EXPECT_LT(e.mean_surface.mean, 1e-9);
    EXPECT_LT(e.landmark_rms.mean, 1e-9);
  }
}

TEST(Generalization, LandmarkErrorFallsWithModesAndEstimatesAreOverShapes) {
  const Generalization g = generalization(torus_cohort({.shapes = 7}), by_shape, RunContext(2));
  for (std::size_t k = 0; k < g.by_modes.size(); ++k) {
    const ErrorsAtModes& e = g.by_modes[k];
    double sum = 0, squares = 0;
    for (const ShapeError& item : e.items) sum += item.mean_surface / 7;
    for (const ShapeError& item : e.items) squares += (item.mean_surface - sum) * (item.mean_surface - sum);
    EXPECT_NEAR(e.mean_surface.mean, sum, 1e-12);
    EXPECT_NEAR(e.mean_surface.standard_error, std::sqrt(squares / 6 / 7), 1e-12);
    for (std::size_t i = 0; k > 0 && i < 7; ++i)
      EXPECT_LE(e.items[i].landmark_rms, g.by_modes[k - 1].items[i].landmark_rms + 1e-12);
  }
}

TEST(Generalization, MovingTheInputsWithTheirLandmarksChangesNothing) {
  CorrespondingCohort cohort = torus_cohort({.shapes = 4});
  const Generalization before = generalization(cohort, by_shape, RunContext(1));
  for (std::size_t s = 0; s < 4; ++s) {
    Rng rng(100 + s);
    const RigidTransform pose = testing::random_pose(rng);
    cohort.corresponding[s] = transformed(cohort.corresponding[s], pose);
    cohort.inputs[s] = transformed(cohort.inputs[s], pose);
  }
  const Generalization after = generalization(cohort, by_shape, RunContext(1));
  const auto a = flat(before), b = flat(after);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-6);
}

TEST(Generalization, ThreadsChangeNothing) {
  const CorrespondingCohort cohort = torus_cohort({.shapes = 6});
  EXPECT_EQ(flat(generalization(cohort, by_subject, RunContext(1))),
            flat(generalization(cohort, by_subject, RunContext(3))));
}

TEST(LeftOutTogether, AreTheShapesOfASubjectInOrderOfItsFirst) {
  using Groups = std::vector<std::vector<int>>;
  const std::vector<std::string> subjects{"b", "a", "b", "c", "a", "b"};
  EXPECT_EQ(left_out_together(6, subjects, LeaveOut::subject), (Groups{{0, 2, 5}, {1, 4}, {3}}));
  EXPECT_EQ(left_out_together(3, subjects, LeaveOut::shape), (Groups{{0}, {1}, {2}}));
  EXPECT_EQ(left_out_together(3, {}, LeaveOut::shape), (Groups{{0}, {1}, {2}}));
  EXPECT_TRUE(left_out_together(0, {}, LeaveOut::subject).empty());
}

TEST(Generalization, RefusesWhatCannotBeLeftOut) {
  CorrespondingCohort cohort = torus_cohort({.shapes = 4});
  cohort.subjects = {"a", "a", "a", "b"};
  EXPECT_THROW(generalization(cohort, by_subject, RunContext(1)), InvalidInput);
  cohort.subjects.clear();
  EXPECT_THROW(generalization(cohort, by_subject, RunContext(1)), InvalidInput);
  EXPECT_NO_THROW(generalization(cohort, by_shape, RunContext(1)));
  GeneralizationOptions none = by_shape;
  none.samples = 0;
  EXPECT_THROW(generalization(cohort, none, RunContext(1)), InvalidInput);
  EXPECT_THROW(generalization(torus_cohort({.shapes = 2}), by_shape, RunContext(1)), InvalidInput);
}

}  // namespace
}  // namespace foramen
