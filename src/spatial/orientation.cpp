#include "spatial/orientation.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace foramen::detail {
namespace {

// Half the distance from 1 to the next double, and the bounds of the rounding errors of the two determinants,
// relative to the sums of the absolute values of their terms [shewchuk1997].
constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;
constexpr double bound_in_space = (7 + 56 * unit_roundoff) * unit_roundoff;
constexpr double bound_in_plane = (3 + 16 * unit_roundoff) * unit_roundoff;

/// head + tail is exact.
struct TwoTerms {
  double head, tail;
};

TwoTerms exact_sum(double a, double b) {
  const double sum = a + b, b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

TwoTerms exact_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

/// The exact sum of at most `capacity` doubles. It is stored as non-overlapping terms of increasing size, so
/// the last term has the sign of the sum (GROW-EXPANSION without zero terms, Shewchuk 1997).
template <std::size_t capacity>
class ExactSum {
 public:
  void add(double x) {
    if (x == 0) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const TwoTerms sum = exact_sum(x, terms_[i]);
      if (sum.tail != 0) terms_[kept++] = sum.tail;
      x = sum.head;
    }
    if (x != 0) terms_[kept++] = x;
    count_ = kept;
  }
  void add_product(double a, double b) {
    const TwoTerms ab = exact_product(a, b);
    add(ab.tail);
    add(ab.head);
  }
  void add_product(double a, double b, double c) {
    const TwoTerms ab = exact_product(a, b);
    add_product(ab.tail, c);
    add_product(ab.head, c);
  }
  int sign() const { return count_ == 0 ? 0 : terms_[count_ - 1] > 0 ? 1 : -1; }

 private:
  std::array<double, capacity> terms_{};
  std::size_t count_ = 0;
};

template <int dimension>
using ExactVector = std::array<std::array<double, 2>, dimension>;

/// to - from.
template <class Point>
auto exact_difference(const Point& to, const Point& from) {
  ExactVector<Point::RowsAtCompileTime> d;
  for (std::size_t i = 0; i < d.size(); ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    const TwoTerms terms = exact_sum(to[axis], -from[axis]);
    d[i] = {terms.head, terms.tail};
  }
  return d;
}

int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto u = exact_difference(b, a), v = exact_difference(c, a), w = exact_difference(d, a);
  // 6 permutations, 8 combinations of heads and tails of three factors, 4 terms of each product
  ExactSum<6 * 8 * 4> determinant;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    for (const double x : u[i])
      for (const double y : v[j])
        for (const double z : w[k]) determinant.add_product(x, y, z);
    for (const double x : u[i])
      for (const double y : v[k])
        for (const double z : w[j]) determinant.add_product(-x, y, z);
  }
  return determinant.sign();
}

int exact_orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  const auto u = exact_difference(b, a), v = exact_difference(c, a);
  ExactSum<2 * 4 * 2> determinant;
  for (const double x : u[0])
    for (const double y : v[1]) determinant.add_product(x, y);
  for (const double x : u[1])
    for (const double y : v[0]) determinant.add_product(-x, y);
  return determinant.sign();
}

}  // namespace

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const double yz = v[1] * w[2], zy = v[2] * w[1];
  const double zx = v[2] * w[0], xz = v[0] * w[2];
  const double xy = v[0] * w[1], yx = v[1] * w[0];
  const double determinant = u[0] * (yz - zy) + u[1] * (zx - xz) + u[2] * (xy - yx);
  const double size = (std::abs(yz) + std::abs(zy)) * std::abs(u[0]) +
                      (std::abs(zx) + std::abs(xz)) * std::abs(u[1]) +
                      (std::abs(xy) + std::abs(yx)) * std::abs(u[2]);
  const double bound = bound_in_space * size;
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  return exact_orientation(a, b, c, d);
}

int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 u = b - a, v = c - a;
  const double left = u[0] * v[1], right = u[1] * v[0];
  const double determinant = left - right, bound = bound_in_plane * (std::abs(left) + std::abs(right));
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  return exact_orientation(a, b, c);
}

}  // namespace foramen::detail
