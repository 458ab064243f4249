#include "render/vertebra_scenes.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"

namespace foramen {
namespace {

constexpr Colour bone{226, 214, 196}, red{214, 30, 30};
// The size of a picture relative to that of its contents.
constexpr double margin = 1.06;

}  // namespace

Mat3 picture_axes(const Vec3& direction, const Vec3& up) {
  Mat3 axes;
  axes.col(2) = direction.normalized();
  axes.col(0) = axes.col(2).cross(up).normalized();
  axes.col(1) = axes.col(0).cross(axes.col(2));
  return axes;
}

Camera frame(std::span<const Vec3> points, const Vec3& direction, const Vec3& up) {
  FORAMEN_ASSERT(!points.empty());
  const Mat3 axes = picture_axes(direction, up);
  std::vector<Vec3> seen;
  seen.reserve(points.size());
  for (const Vec3& p : points) seen.emplace_back(axes.transpose() * p);
  const BoundingBox box = bounding_box(seen);
  const Vec3 size = margin * (box.high - box.low);
  return {axes * ((box.low + box.high) / 2), axes.col(2), axes.col(1), size.x(), size.y()};
}

Camera view_of(std::span<const Vec3> points, View view, std::span<const Vec3> shown) {
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : points) centre += p;
  centre /= static_cast<double>(points.size());
  Mat3 covariance = Mat3::Zero();
  for (const Vec3& p : points) covariance += (p - centre) * (p - centre).transpose();
  const Mat3 axes = Eigen::SelfAdjointEigenSolver<Mat3>(covariance).eigenvectors();  // shortest first
  const int along = view == View::along_shortest ? 0 : view == View::along_middle ? 1 : 2;
  const int upward = along == 0 ? 1 : 0;
  // The sign of an eigenvector is arbitrary. The skewness of the points determines it, so that similar shapes
  // are shown from the same side.
  const auto oriented = [&](int axis) {
    double skew = 0;
    for (const Vec3& p : points) skew += std::pow((p - centre).dot(axes.col(axis)), 3);
    return Vec3(skew < 0 ? Vec3(-axes.col(axis)) : Vec3(axes.col(axis)));
  };
  return frame(shown, -oriented(along), -oriented(upward));
}

std::vector<Scene> at_one_scale(const Scene& contents, const std::vector<Camera>& cameras) {
  FORAMEN_ASSERT(!cameras.empty());
  double height_mm = 0;
  for (const Camera& camera : cameras) height_mm = std::max(height_mm, camera.height_mm);
  std::vector<Scene> scenes;
  for (const Camera& camera : cameras) {
    scenes.push_back(contents);
    scenes.back().camera = camera;
    scenes.back().camera.height_mm = height_mm;
  }
  return scenes;
}

std::vector<Scene> three_views(std::span<const Vec3> points, const Scene& contents) {
  std::vector<Camera> cameras;
  for (View view : {View::along_shortest, View::along_middle, View::along_longest})
    cameras.push_back(view_of(points, view, points));
  return at_one_scale(contents, cameras);
}

SceneSurface marked_surface(const TriangleSoup& surface, const std::vector<int>& marked, SurfaceStyle style) {
  SceneSurface scene;
  scene.soup = surface;
  scene.style = style;
  scene.face_colours.assign(surface.triangles.size(), bone);
  for (int f : marked) scene.face_colours[f] = red;
  return scene;
}

}  // namespace foramen
