#include "render/close_up.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "render/vertebra_scenes.hpp"

namespace foramen {
namespace {

// The direction with this index of `count` directions spread evenly over the sphere (Fibonacci lattice).
Vec3 direction_of(int index, int count) {
  const double z = 1 - (2 * index + 1.0) / count, turn = 2 * std::numbers::pi / std::numbers::phi * index;
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

Vec3 up_for(const Vec3& direction) {
  return std::abs(direction.z()) < std::abs(direction.y()) ? Vec3::UnitZ() : Vec3::UnitY();
}

// A depth buffer of a parallel projection, which also stores the pixels that show a marked triangle.
class DepthImage {
 public:
  DepthImage(const BoundingBox& seen, double pixel_mm)
      : low_(seen.low),
        pixel_(pixel_mm),
        width_(1 + static_cast<int>((seen.high.x() - seen.low.x()) / pixel_mm)),
        height_(1 + static_cast<int>((seen.high.y() - seen.low.y()) / pixel_mm)),
        depth_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_),
               std::numeric_limits<double>::infinity()),
        marked_(depth_.size(), false) {}

  /// \param t  corners in picture coordinates: right, up, away
  void draw(const std::array<Vec3, 3>& t, bool marked) {
    const Vec2 a = t[0].head<2>(), b = t[1].head<2>() - a, c = t[2].head<2>() - a;
    const double doubled_area = b.x() * c.y() - b.y() * c.x();
    if (doubled_area == 0) return;  // seen edge on
    const auto [left, right] = std::minmax({t[0].x(), t[1].x(), t[2].x()});
    const auto [bottom, top] = std::minmax({t[0].y(), t[1].y(), t[2].y()});
    for (int y = pixel(bottom - low_.y()); y <= pixel(top - low_.y()); ++y)
      for (int x = pixel(left - low_.x()); x <= pixel(right - low_.x()); ++x) {
        const Vec2 p = low_.head<2>() + pixel_ * Vec2(x + 0.5, y + 0.5) - a;
        const double v = (p.x() * c.y() - p.y() * c.x()) / doubled_area;
        const double w = (b.x() * p.y() - b.y() * p.x()) / doubled_area;
        if (v < 0 || w < 0 || v + w > 1) continue;
        const double depth = t[0].z() + v * (t[1].z() - t[0].z()) + w * (t[2].z() - t[0].z());
        const std::size_t at = index(x, y);
        if (depth >= depth_[at]) continue;
        depth_[at] = depth;
        marked_[at] = marked;
      }
  }

  struct Window {
    Vec3 centre;  // in picture coordinates
    int marked = 0;
  };
  /// The square window with most marked pixels, by a summed-area table.
  Window best_window(double size_mm) const {
    const int size = std::max(1, pixel(size_mm));
    std::vector<int> sums(static_cast<std::size_t>(width_ + 1) * static_cast<std::size_t>(height_ + 1), 0);
    const auto sum = [&](int x, int y) -> int& {
      const int column = std::clamp(x, 0, width_), row = std::clamp(y, 0, height_);
      return sums[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_ + 1) +
                  static_cast<std::size_t>(column)];
    };
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x)
        sum(x + 1, y + 1) = marked_[index(x, y)] + sum(x, y + 1) + sum(x + 1, y) - sum(x, y);
    Window best{low_ + pixel_ * Vec3(width_ / 2.0, height_ / 2.0, 0)};
    for (int y = -size / 2; y < height_ - size / 2; ++y)
      for (int x = -size / 2; x < width_ - size / 2; ++x) {
        const int marked = sum(x + size, y + size) - sum(x, y + size) - sum(x + size, y) + sum(x, y);
        if (marked <= best.marked) continue;
        best = {low_ + pixel_ * Vec3(x + size / 2.0, y + size / 2.0, 0), marked};
      }
    return best;
  }

 private:
  int pixel(double mm) const { return static_cast<int>(mm / pixel_); }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  Vec3 low_;
  double pixel_;
  int width_, height_;
  std::vector<double> depth_;
  std::vector<bool> marked_;
};

DepthImage depth_image(const TriangleSoup& surface, const std::vector<bool>& marked, const Mat3& axes,
                       double pixel_mm) {
  std::vector<Vec3> seen;
  seen.reserve(surface.points.size());
  for (const Vec3& p : surface.points) seen.emplace_back(axes.transpose() * p);
  DepthImage image(bounding_box(seen), pixel_mm);
  const auto point = [&](int v) { return seen[v]; };
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    const auto& t = surface.triangles[f];
    image.draw({point(t[0]), point(t[1]), point(t[2])}, marked[f]);
  }
  return image;
}

}  // namespace

Camera close_up(const TriangleSoup& surface, const std::vector<int>& marked, const CloseUpOptions& options) {
  FORAMEN_ASSERT(!marked.empty() && options.pixel_mm > 0 && options.directions > 0);
  std::vector<bool> is_marked(surface.triangles.size(), false);
  for (int f : marked) is_marked[f] = true;
  Camera camera;
  int most = -1;
  for (int i = 0; i < options.directions; ++i) {
    const Vec3 direction = direction_of(i, options.directions);
    const Mat3 axes = picture_axes(direction, up_for(direction));
    const auto window = depth_image(surface, is_marked, axes, options.pixel_mm).best_window(options.size_mm);
    if (window.marked <= most) continue;
    most = window.marked;
    camera = {axes * window.centre, axes.col(2), axes.col(1), options.size_mm, options.size_mm};
  }
  return camera;
}

}  // namespace foramen
