#include "foramen/apply/complete_surface.hpp"

#include <gtest/gtest.h>

#include "apply/lopsided_family.hpp"
#include "apply/part_surface.hpp"
#include "foramen/core/error.hpp"

namespace foramen {
namespace {

using testing::below_x;
using testing::lopsided_model;
using testing::member;
using testing::posed;
using testing::some_pose;

constexpr double cut_x = 12, strength = 1.45;  // the part contains some of the bump, but not the far side

CompletedSurface completed(const TriangleSoup& part, const CompleteSurfaceOptions& options = {}) {
  return complete_surface(part_surface(part), lopsided_model(), RunContext(2), options);
}

double rms(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST(CompleteSurface, FindsTheMemberOfTheFamilyInAnyPose) {
  const TriangleSoup truth = member(strength), part = below_x(truth, cut_x);
  ASSERT_LT(part.triangles.size(), truth.triangles.size() * 4 / 5);
  const double of_mean = rms(member(1).points, truth.points);
  for (const double angle : {0.0, 2.5}) {
    const RigidTransform pose = some_pose(angle);
    const CompletedSurface result = completed(posed(part, pose), {.noise_mm = 0.1, .beyond_modes = 0});
    const double error = rms(unflattened(result.shape.mean), posed(truth, pose).points);
    EXPECT_LT(error, 0.15);
    EXPECT_LT(error, 0.2 * of_mean);
    EXPECT_LT(result.distance_mm, 0.1);
    EXPECT_GT(result.matched_share, 0.95);
    // to_model() undoes the pose.
    EXPECT_LT((result.to_model(pose * truth.points[5]) - truth.points[5]).norm(), 0.3);
  }
}

TEST(CompleteSurface, IsSurerWhereItSees) {
  const TriangleSoup truth = member(strength);
  const CompletedSurface result = completed(below_x(truth, cut_x));
  const std::vector<double> deviations = standard_deviations(result.shape);
  double seen = 0, unseen = 0;
  int count_seen = 0, count_unseen = 0;
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    // A landmark well beyond the border does not count as seen.
    EXPECT_FALSE(truth.points[i].x() > cut_x + 5 && result.seen[i]) << truth.points[i].transpose();
    (result.seen[i] ? seen : unseen) += deviations[i];
    ++(result.seen[i] ? count_seen : count_unseen);
  }
  EXPECT_GT(count_seen, count_unseen);
  EXPECT_LT(2 * seen / count_seen, unseen / count_unseen);
}

TEST(CompleteSurface, LessNoiseIsLessDeviation) {
  const TriangleSoup part = below_x(member(strength), cut_x);
  const auto mean_deviation = [&](double noise) {
    double sum = 0;
    for (const double d : standard_deviations(completed(part, {.noise_mm = noise, .beyond_modes = 0}).shape))
      sum += d;
    return sum;
  };
  EXPECT_LT(mean_deviation(0.2), 0.6 * mean_deviation(0.6));
}

TEST(CompleteSurface, LeavesOutWhatIsNotOfTheShape) {
  const TriangleSoup truth = member(strength);
  TriangleSoup part = below_x(truth, cut_x);
  // A plate beside the part, in place of metal or a piece of another bone.
  const int first = static_cast<int>(part.points.size());
  for (int i = 0; i < 11; ++i)
    for (int k = 0; k < 11; ++k) part.points.emplace_back(-15 + 3 * i, -15 + 3 * k, -30);
  for (int i = 0; i < 10; ++i)
    for (int k = 0; k < 10; ++k) {
      const int a = first + 11 * i + k;
      part.triangles.push_back({a, a + 11, a + 12});
      part.triangles.push_back({a, a + 12, a + 1});
    }
  const CompletedSurface result = completed(part, {.noise_mm = 0.1, .beyond_modes = 0});
  EXPECT_LT(result.matched_share, 0.95);
  EXPECT_LT(rms(unflattened(result.shape.mean), truth.points), 0.3);
}

TEST(CompleteSurface, FindsTheSizeWhereSizeIsNoPartOfShape) {
  TriangleSoup truth = member(strength);
  const TriangleSoup part = below_x(truth, cut_x);
  const auto grown = [](TriangleSoup soup) {
    for (Vec3& p : soup.points) p *= 1.06;
    return soup;
  };
  const CompletedSurface result =
      completed(grown(part), {.scale = ScaleMode::remove, .noise_mm = 0.1, .beyond_modes = 0});
  EXPECT_NEAR(result.to_model.scale, 1 / 1.06, 0.004);
  EXPECT_LT(rms(unflattened(result.shape.mean), grown(truth).points), 0.3);
}

TEST(CompleteSurface, RefusesWhatIsOutOfRange) {
  const TriangleSoup part = below_x(member(1), cut_x);
  EXPECT_THROW(completed(part, {.noise_mm = 0}), InvalidInput);
  EXPECT_THROW(completed(part, {.match = {.tangential_share = 0}}), InvalidInput);
  EXPECT_THROW(completed(part, {.beyond_modes = -1}), InvalidInput);
}

}  // namespace
}  // namespace foramen
