#include "topology/lifted_loop.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "foramen/core/geometry.hpp"
#include "foramen/core/rng.hpp"

namespace foramen::topology_detail {
namespace {

// A polygon of the circle around a centre, in the plane of two unit vectors.
std::vector<Vec3> circle(const Vec3& centre, const Vec3& x, const Vec3& y, int corners, double radius = 1) {
  std::vector<Vec3> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    points.push_back(centre + radius * (std::cos(angle) * x + std::sin(angle) * y));
  }
  return points;
}

const std::vector<Vec3> flat = circle(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), 7);
const std::vector<Vec3> through = circle(Vec3::UnitX(), Vec3::UnitX(), Vec3::UnitZ(), 5);
const std::vector<Vec3> aside = circle(3 * Vec3::UnitX(), Vec3::UnitX(), Vec3::UnitZ(), 5);

std::vector<Vec3> backward(std::vector<Vec3> loop) {
  std::reverse(loop.begin(), loop.end());
  return loop;
}

TEST(GaussIntegral, OfPolygonsIsAnInteger) {
  const double linked = gauss_integral(flat, through);
  EXPECT_NEAR(std::abs(linked), 1, 1e-12);
  EXPECT_NEAR(gauss_integral(flat, aside), 0, 1e-12);
  EXPECT_NEAR(gauss_integral(through, flat), linked, 1e-12) << "it is symmetric";
  EXPECT_NEAR(gauss_integral(flat, backward(through)), -linked, 1e-12);
  EXPECT_NEAR(gauss_integral(backward(flat), backward(through)), linked, 1e-12);
}

TEST(GaussIntegral, CountsHowOftenALoopGoesThrough) {
  std::vector<Vec3> three_times;
  for (int round = 0; round < 3; ++round)
    for (const Vec3& p : circle(Vec3::UnitX(), Vec3::UnitX(), Vec3::UnitZ(), 9, 1 + 0.1 * round))
      three_times.push_back(p);
  EXPECT_NEAR(gauss_integral(flat, three_times), 3 * gauss_integral(flat, through), 1e-12);
}

TEST(GaussIntegral, AMotionChangesNothingAndAReflectionTheSign) {
  RigidTransform motion = RigidTransform::Identity();
  motion.rotate(Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized())).pretranslate(Vec3(100, -50, 7));
  const auto moved = [&](std::vector<Vec3> loop) {
    for (Vec3& p : loop) p = motion * p;
    return loop;
  };
  const auto reflected = [](std::vector<Vec3> loop) {
    for (Vec3& p : loop) p.x() = -p.x();
    return loop;
  };
  const double linked = gauss_integral(flat, through);
  EXPECT_NEAR(gauss_integral(moved(flat), moved(through)), linked, 1e-9);
  EXPECT_NEAR(gauss_integral(reflected(flat), reflected(through)), -linked, 1e-12);
}

TEST(GaussIntegral, OfLoopsThatTouchIsNoInteger) {
  const std::vector<Vec3> triangle{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  const std::vector<std::vector<Vec3>> touching{
      {{1, 0, -1}, {1, 0, 1}, {1, -3, 0}},  // sides, in their middles
      {{0.5, 0, -1}, {0.5, 0, 2}, {1, -3, 0}},
      {{1, 0, 0}, {1, 1, 2}, {1, -1, 2}}};  // a corner on a side
  for (const std::vector<Vec3>& loop : touching) {
    const double integral = gauss_integral(triangle, loop);
    EXPECT_EQ(nearest_integer(integral), std::nullopt) << integral;
  }
}

TEST(NearestInteger, IsGivenOnlyNearOne) {
  EXPECT_EQ(nearest_integer(-1.0009), -1);
  EXPECT_EQ(nearest_integer(2.0009), 2);
  EXPECT_EQ(nearest_integer(2.0011), std::nullopt);
  EXPECT_EQ(nearest_integer(0.5), std::nullopt);
  EXPECT_EQ(nearest_integer(std::nan("")), std::nullopt);
}

}  // namespace
}  // namespace foramen::topology_detail
