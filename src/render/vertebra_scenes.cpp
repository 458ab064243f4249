#include "foramen/render/vertebra_scenes.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>

namespace foramen {
namespace {

constexpr Colour bone{226, 214, 196}, dark_bone{168, 140, 110}, red{214, 40, 40};

// A smooth colour for a place of the torus: hue by the first turn, lightness by the second.
Colour torus_colour(const Vec2& turns) {
  const double pi2 = 2 * 3.14159265358979323846;
  const double light = 0.72 + 0.22 * std::cos(pi2 * turns.y());
  Colour c{};
  for (std::size_t k = 0; k < 3; ++k)
    c[k] = static_cast<unsigned char>(
        255 * light * (0.62 + 0.38 * std::cos(pi2 * (turns.x() - static_cast<double>(k) / 3))));
  return c;
}

}  // namespace

void look(Scene& scene, std::span<const Vec3> points, View view) {
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : points) centre += p;
  centre /= static_cast<double>(points.size());
  Mat3 covariance = Mat3::Zero();
  for (const Vec3& p : points) covariance += (p - centre) * (p - centre).transpose();
  const Mat3 axes = Eigen::SelfAdjointEigenSolver<Mat3>(covariance).eigenvectors();  // shortest first
  const int along = view == View::along_shortest ? 0 : view == View::along_middle ? 1 : 2;
  const int upward = along == 0 ? 1 : 0;
  // The sign of an eigenvector means nothing: let the skew of the points decide, so that similar shapes look
  // alike.
  const auto oriented = [&](int axis) {
    double skew = 0;
    for (const Vec3& p : points) skew += std::pow((p - centre).dot(axes.col(axis)), 3);
    return Vec3(skew < 0 ? Vec3(-axes.col(axis)) : Vec3(axes.col(axis)));
  };
  scene.direction = -oriented(along);
  scene.up = -oriented(upward);
}

Scene torus_map_scene(const TriangleSoup& surface, std::span<const Vec2> turns, std::span<const Vec2i> jumps,
                      const Mat2& lattice) {
  Scene scene;
  SceneSurface flat;
  flat.lit = false;
  flat.edges = true;
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    const auto& t = surface.triangles[f];
    const Vec2& a = turns[static_cast<std::size_t>(t[0])];
    const Vec2 b = turns[static_cast<std::size_t>(t[1])] + jumps[3 * f].cast<double>();
    const Vec2 c = turns[static_cast<std::size_t>(t[2])] - jumps[3 * f + 2].cast<double>();
    const int first = static_cast<int>(flat.soup.points.size());
    for (const Vec2& p : {a, b, c}) {
      const Vec2 plane = lattice * p;
      flat.soup.points.emplace_back(100 * plane.x(), 0, 100 * plane.y());
      flat.vertex_colours.push_back(torus_colour(p));
    }
    flat.soup.triangles.push_back({first, first + 1, first + 2});
  }
  scene.surfaces.push_back(std::move(flat));
  scene.direction = Vec3(0, 1, 0);
  return scene;
}

std::vector<Colour> checkerboard(std::span<const Vec2> turns, int squares) {
  std::vector<Colour> colours;
  for (const Vec2& p : turns) {
    const auto cell = [&](double t) { return static_cast<int>(std::floor(squares * (t - std::floor(t)))); };
    colours.push_back((cell(p.x()) + cell(p.y())) % 2 == 0 ? bone : dark_bone);
  }
  return colours;
}

SceneSurface marked_surface(const TriangleSoup& surface, const std::vector<int>& marked) {
  SceneSurface scene;
  scene.soup = surface;
  scene.edges = true;
  scene.face_colours.assign(surface.triangles.size(), bone);
  for (int f : marked) scene.face_colours[static_cast<std::size_t>(f)] = red;
  return scene;
}

}  // namespace foramen
