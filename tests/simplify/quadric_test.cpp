#include "simplify/quadric.hpp"

#include <gtest/gtest.h>

#include "foramen/core/rng.hpp"

namespace foramen {
namespace {

TEST(Quadric, IsTheSumOfSquaredDistances) {
  const Rng root(8);
  for (int i = 0; i < 100; ++i) {
    Rng rng = root.fork(static_cast<std::uint64_t>(i));
    const auto drawn = [&] { return Vec3(rng.normal(), rng.normal(), rng.normal()); };
    const Vec3 normal = drawn().normalized(), on_plane = drawn(), point = drawn(), x = drawn();
    Quadric to_plane, to_point;
    to_plane.add_plane(2.5, normal, on_plane);
    to_point.add_point(0.5, point);
    EXPECT_NEAR(to_plane(x), 2.5 * std::pow(normal.dot(x - on_plane), 2), 1e-12);
    EXPECT_NEAR(to_plane(x + 7 * normal.cross(x)), to_plane(x), 1e-10) << "moved within the plane";
    EXPECT_NEAR(to_point(x), 0.5 * (x - point).squaredNorm(), 1e-12);
    Quadric both = to_plane;
    both += to_point;
    EXPECT_NEAR(both(x), to_plane(x) + to_point(x), 1e-12);
  }
}

}  // namespace
}  // namespace foramen
