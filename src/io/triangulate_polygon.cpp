#include "io/triangulate_polygon.hpp"

#include <Eigen/Geometry>

#include <limits>

namespace foramen::io_detail {
namespace {

class EarClipping {
 public:
  EarClipping(std::span<const int> corners, std::span<const Vec3> points)
      : corners_(corners.begin(), corners.end()), points_(points) {
    for (std::size_t i = 0; i < corners_.size(); ++i)  // Newell's normal
      normal_ += (at(i) - at(0)).cross(at(i + 1) - at(0));
  }

  std::vector<std::array<int, 3>> triangles() {
    std::vector<std::array<int, 3>> out;
    if (first_corner_sees_all()) {
      for (std::size_t i = 1; i + 1 < corners_.size(); ++i)
        out.push_back({corners_[0], corners_[i], corners_[i + 1]});
      return out;
    }
    while (corners_.size() > 3) {
      const std::size_t ear = best_ear(), n = corners_.size();
      out.push_back({corners_[(ear + n - 1) % n], corners_[ear], corners_[(ear + 1) % n]});
      corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    out.push_back({corners_[0], corners_[1], corners_[2]});
    return out;
  }

 private:
  const Vec3& at(std::size_t i) const {
    return points_[static_cast<std::size_t>(corners_[i % corners_.size()])];
  }
  double turn(const Vec3& a, const Vec3& b, const Vec3& c) const { return (b - a).cross(c - a).dot(normal_); }

  bool first_corner_sees_all() const {
    for (std::size_t i = 1; i + 1 < corners_.size(); ++i)
      if (!(turn(at(0), at(i), at(i + 1)) > 0)) return false;
    return true;
  }

  bool is_ear(std::size_t i) const {
    const std::size_t n = corners_.size();
    const Vec3 &a = at(i + n - 1), &b = at(i), &c = at(i + 1);
    if (!(turn(a, b, c) > 0)) return false;
    for (std::size_t k = i + 2; k < i + n - 1; ++k) {
      const Vec3& p = at(k);
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0 && p != a && p != b && p != c)
        return false;
    }
    return true;
  }

  // A polygon that crosses itself or has no area may have no ear; then the shortest cut is made anyway.
  std::size_t best_ear() const {
    const std::size_t n = corners_.size();
    std::size_t best = 0;
    double shortest = std::numeric_limits<double>::infinity();
    bool best_is_ear = false;
    for (std::size_t i = 0; i < n; ++i) {
      const double cut = (at(i + 1) - at(i + n - 1)).squaredNorm();
      const bool ear = is_ear(i);
      if ((ear && !best_is_ear) || (ear == best_is_ear && cut < shortest)) {
        best = i;
        shortest = cut;
        best_is_ear = ear;
      }
    }
    return best;
  }

  std::vector<int> corners_;
  std::span<const Vec3> points_;
  Vec3 normal_ = Vec3::Zero();
};

}  // namespace

std::vector<std::array<int, 3>> triangulate_polygon(std::span<const int> corners,
                                                    std::span<const Vec3> points) {
  return EarClipping(corners, points).triangles();
}

}  // namespace foramen::io_detail
