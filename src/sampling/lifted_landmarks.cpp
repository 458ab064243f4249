#include "sampling/lifted_landmarks.hpp"

#include <algorithm>

#include "core/parallel.hpp"
#include "foramen/core/geometry.hpp"
#include "sampling/lift_to_surface.hpp"

namespace foramen::detail {
namespace {

// The same values as in sampled_flips(), which makes the final decision.
constexpr double margin_per_edge = 0.25;
constexpr double degenerate_height = 1e-12;

bool is_degenerate(const std::array<Vec3, 3>& t) {
  const double longest2 =
      std::max({(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()});
  return 2 * area(t) <= degenerate_height * longest2;
}

}  // namespace

LiftedLandmarks::LiftedLandmarks(std::span<const LandmarkShape> shapes, const TorusTriangulation& mesh,
                                 const RunContext& ctx)
    : shapes_(shapes.begin(), shapes.end()),
      points_(shapes.size()),
      margin_(shapes.size(), 0.0),
      surfaces_(shapes.size()) {
  for (const LandmarkShape& s : shapes_) FORAMEN_ASSERT(s.locator && s.tree);
  parallel_for(this->shapes(), ctx, [&](int s) {
    points_[s].reserve(mesh.vertex_slots());
    for (int v = 0; v < mesh.vertex_slots(); ++v) points_[s].push_back(lift(s, mesh.place(v)));
  });
  measure_edges(mesh);
}

Vec3 LiftedLandmarks::lift(int shape, Fixed2 place) const {
  const TorusLocator& locator = *shapes_[shape].locator;
  return position(locator.mesh(), locator.locate(to_turns(place - whole_turns(floor_turns(place)))));
}

void LiftedLandmarks::update(int vertex, Fixed2 place) {
  for (int s = 0; s < shapes(); ++s) {
    const std::size_t needed = static_cast<std::size_t>(vertex) + 1;
    if (points_[s].size() < needed) points_[s].resize(needed, Vec3::Zero());
    points_[s][vertex] = lift(s, place);
  }
}

bool LiftedLandmarks::guilty(int shape, const std::array<Vec3, 3>& triangle) const {
  if (is_degenerate(triangle)) return true;
  const Vec3 normal = area_vector(triangle);
  const TriangleTree& tree = *shapes_[shape].tree;
  const Vec3 centroid = (triangle[0] + triangle[1] + triangle[2]) / 3;
  const auto opposes = [&](FaceId f) { return normal.dot(area_vector(tree.mesh().triangle(f))) < 0; };
  const ClosestPoint closest = tree.closest(centroid);
  if (!opposes(closest.on.face)) return false;
  const auto near = tree.faces_within(centroid, std::sqrt(closest.squared_distance) + margin_[shape]);
  return std::all_of(near.begin(), near.end(),
                     [&](FaceId f) { return is_degenerate(tree.mesh().triangle(f)) || opposes(f); });
}

void LiftedLandmarks::measure_edges(const TorusTriangulation& mesh) {
  for (int s = 0; s < shapes(); ++s) {
    double sum = 0;
    for (int h = 0; h < mesh.halfedge_slots(); ++h)
      sum += (point(s, mesh.to(h)) - point(s, mesh.from(h))).norm();
    margin_[s] = margin_per_edge * sum / mesh.halfedge_slots();
  }
}

void LiftedLandmarks::refresh_surface(int shape, const TorusTriangulation& mesh) {
  surfaces_[shape].emplace(corresponding(shape, mesh), TreeNormals::none);
}

std::vector<FaceId> LiftedLandmarks::faces_met(int shape, const NumberedTriangle& triangle) const {
  if (!surfaces_[shape]) return {};
  const TriangleTree& tree = *surfaces_[shape];
  const auto& p = triangle.points;
  const Vec3 centroid = (p[0] + p[1] + p[2]) / 3;
  const double radius =
      std::max({(p[0] - centroid).norm(), (p[1] - centroid).norm(), (p[2] - centroid).norm()});
  std::vector<FaceId> met = tree.faces_within(centroid, radius);
  std::erase_if(met, [&](FaceId f) { return !meet(triangle, numbered_triangle(tree.mesh(), f)); });
  return met;
}

Mesh LiftedLandmarks::corresponding(int shape, const TorusTriangulation& mesh) const {
  TriangleSoup soup{points_[shape], {}};
  for (int f = 0; f < mesh.face_slots(); ++f) soup.triangles.push_back(mesh.corners(f));
  return build_mesh(std::move(soup));
}

bool meet(const NumberedTriangle& a, const NumberedTriangle& b) {
  return has_area(a.points) && has_area(b.points) && triangles_meet(a, b);
}

double smallest_angle(const std::array<Vec3, 3>& t) {
  double smallest = 4;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 a = t[(k + 1) % 3] - t[k], b = t[(k + 2) % 3] - t[k];
    smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)));
  }
  return smallest;
}

}  // namespace foramen::detail
