#include "spatial/orientation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "foramen/core/geometry.hpp"
#include "foramen/core/rng.hpp"

namespace foramen::detail {
namespace {

__extension__ using Wide = __int128;

int sign(Wide x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

// Integers of up to `bits` bits: for 40 bits the determinant has at most 3 * 41 + 3 = 126.
Vec3 integer_point(Rng& rng, int bits) {
  const double size = std::ldexp(1.0, bits);
  return {std::round(rng.uniform(-size, size)), std::round(rng.uniform(-size, size)),
          std::round(rng.uniform(-size, size))};
}

int oracle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  std::array<std::array<Wide, 3>, 3> m;
  const std::array rows{Vec3(b - a), Vec3(c - a), Vec3(d - a)};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      m[i][j] = static_cast<std::int64_t>(rows[i][static_cast<Eigen::Index>(j)]);
  return sign(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
              m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
              m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
}

TEST(Orientation, IsThatOfTheAxes) {
  const Vec3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  EXPECT_EQ(orientation(o, x, y, z), 1);
  EXPECT_EQ(orientation(o, y, x, z), -1);
  EXPECT_EQ(orientation(o, x, y, Vec3(3, -2, 0)), 0);
  EXPECT_EQ(orientation(Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)), 1);
  EXPECT_EQ(orientation(Vec2(0, 0), Vec2(0, 1), Vec2(1, 0)), -1);
  EXPECT_EQ(orientation(Vec2(0, 0), Vec2(1, 2), Vec2(3, 6)), 0);
}

// Points with large integer coordinates within one unit of a plane. Most determinants are smaller than the
// rounding errors of doubles.
TEST(Orientation, AgreesWithIntegersWhereDoublesDoNotSuffice) {
  Rng rng(1);
  int lost = 0, in_plane = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Vec3 a = integer_point(rng, 36), b = integer_point(rng, 36), c = integer_point(rng, 36);
    const int m = rng.below(5) - 2, n = rng.below(5) - 2;
    Vec3 d = a + m * (b - a) + n * (c - a);
    if (rng.below(3) > 0) d += Vec3(rng.below(3) - 1, rng.below(3) - 1, rng.below(3) - 1);
    const int expected = oracle(a, b, c, d);
    ASSERT_EQ(orientation(a, b, c, d), expected);
    const double rounded = (b - a).dot((c - a).cross(d - a));
    lost += (rounded > 0) - (rounded < 0) != expected;
    in_plane += expected == 0;
  }
  EXPECT_GT(lost, 100) << "the trials are too easy";
  EXPECT_GT(in_plane, 1000);
}

// The numbers have very different sizes, so that their differences cannot be represented as doubles. In the
// plane z = x the sign is 0. Outside the plane it is the sign of the step times the orientation of the three
// points seen along z.
TEST(Orientation, KeepsWhatDifferencesRoundAway) {
  Rng rng(2);
  const auto any = [&] { return std::ldexp(rng.uniform(0.5, 1), -rng.below(120)); };
  const double tiny = std::ldexp(1.0, -170);
  for (int trial = 0; trial < 2000; ++trial) {
    const double x = any(), y = any();
    // Counter-clockwise, since a is nearer to the origin than to the other two.
    const Vec2 a(any() / 8, any() / 8), b(1 + any() / 8, any() / 8), c(any() / 8, 1 + any() / 8);
    const auto lifted = [](const Vec2& p) { return Vec3(p.x(), p.y(), p.x()); };
    const Vec3 in_plane(x, y, x);
    ASSERT_EQ(orientation(lifted(a), lifted(b), lifted(c), in_plane), 0);
    const double up = std::nextafter(x, 2.0), down = std::nextafter(x, 0.0);
    ASSERT_EQ(orientation(lifted(a), lifted(b), lifted(c), Vec3(x, y, up)), 1);
    ASSERT_EQ(orientation(lifted(a), lifted(b), lifted(c), Vec3(x, y, down)), -1);
    // A step of 2^-170 from a point of size 1 is lost in the difference of the two.
    ASSERT_EQ(orientation(lifted(a), lifted(b), lifted(c), Vec3(0, y, tiny)), 1);
    // The same test in the plane, for the line y = x.
    const Vec2 low = Vec2::Constant(any() / 8), high = Vec2::Constant(1 + any());
    ASSERT_EQ(orientation(low, high, Vec2(x, x)), 0);
    ASSERT_EQ(orientation(low, high, Vec2(x, up)), 1);
    ASSERT_EQ(orientation(low, high, Vec2(x, down)), -1);
    ASSERT_EQ(orientation(low, high, Vec2(0, tiny)), 1);
  }
}

// An exact sign changes with every exchange of two points, however near the four are to a plane.
TEST(Orientation, IsAlternating) {
  Rng rng(3);
  for (int trial = 0; trial < 2000; ++trial) {
    std::array<Vec3, 4> p;
    for (Vec3& q : p) {
      q = Vec3(rng.normal(), rng.normal(), 0);
      q.z() = 0.1 * q.x() + 0.3 * q.y() + 1;
    }
    std::array<int, 4> order{0, 1, 2, 3};
    const int first = orientation(p[0], p[1], p[2], p[3]);
    do {
      int inversions = 0;
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j) inversions += order[i] > order[j];
      const auto at = [&](std::size_t i) { return p[order[i]]; };
      ASSERT_EQ(orientation(at(0), at(1), at(2), at(3)), inversions % 2 == 0 ? first : -first);
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TEST(Orientation, InThePlaneAgreesWithIntegers) {
  Rng rng(4);
  int lost = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    // n^2 - (n + 1)(n - 1) = 1 is much smaller than its terms of 100 bits.
    const Vec3 p = integer_point(rng, 50);
    const Vec2 a = p.head<2>(), b = a + Vec2(p.z(), p.z() + 1);
    const Vec2 c = a + Vec2(p.z() - 1, p.z()) + rng.below(2) * Vec2(rng.below(3) - 1, rng.below(3) - 1);
    const auto wide = [](double x) { return Wide{static_cast<std::int64_t>(x)}; };
    const Wide exact = (wide(b.x()) - wide(a.x())) * (wide(c.y()) - wide(a.y())) -
                       (wide(b.y()) - wide(a.y())) * (wide(c.x()) - wide(a.x()));
    ASSERT_EQ(orientation(a, b, c), sign(exact));
    const Vec2 u = b - a, v = c - a;
    const double rounded = u.x() * v.y() - u.y() * v.x();
    lost += (rounded > 0) - (rounded < 0) != sign(exact);
  }
  EXPECT_GT(lost, 100) << "the trials are too easy";
}

}  // namespace
}  // namespace foramen::detail
