#include "foramen/core/geometry.hpp"

#include <cmath>
#include <utility>

#include "foramen/core/error.hpp"

namespace foramen {

BoundingBox bounding_box(std::span<const Vec3> points) {
  FORAMEN_ASSERT(!points.empty());
  BoundingBox box{points[0], points[0]};
  for (const Vec3& p : points) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

Vec3 area_vector(const std::array<Vec3, 3>& t) { return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]); }

double area(const std::array<Vec3, 3>& t) { return area_vector(t).norm(); }

Vec3 unit_normal(const std::array<Vec3, 3>& t) {
  const Vec3 n = area_vector(t);
  const double length = n.norm();
  return length > 0 ? Vec3(n / length) : Vec3(Vec3::Zero());
}

double total_area(const Mesh& mesh) {
  double sum = 0;
  for (FaceId f : mesh.faces()) sum += area(mesh.triangle(f));
  return sum;
}

double signed_volume(const Mesh& mesh) {
  // Relative to the first vertex, so that a mesh far from the origin loses no digits.
  const Vec3& origin = mesh.position(VertexId(0));
  double sum = 0;
  for (FaceId f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    sum += (t[0] - origin).dot((t[1] - origin).cross(t[2] - origin));
  }
  return sum / 6;
}

Vec3 surface_centroid(const Mesh& mesh) {
  Vec3 sum = Vec3::Zero();
  double weight = 0;
  for (FaceId f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    const double a = area(t);
    sum += a * (t[0] + t[1] + t[2]) / 3;
    weight += a;
  }
  FORAMEN_ASSERT(weight > 0);
  return sum / weight;
}

VertexMap<double> vertex_areas(const Mesh& mesh) {
  VertexMap<double> areas(mesh.vertex_count(), 0.0);
  for (FaceId f : mesh.faces()) {
    const double third = area(mesh.triangle(f)) / 3;
    for (VertexId v : mesh.corners(f)) areas[v] += third;
  }
  return areas;
}

VertexMap<Vec3> vertex_normals(const Mesh& mesh) {
  VertexMap<Vec3> normals(mesh.vertex_count(), Vec3::Zero());
  for (FaceId f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    const Vec3 n = unit_normal(t);
    const auto corners = mesh.corners(f);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = t[(k + 1) % 3] - t[k], b = t[(k + 2) % 3] - t[k];
      normals[corners[k]] += std::atan2(a.cross(b).norm(), a.dot(b)) * n;
    }
  }
  for (Vec3& n : normals) {
    const double length = n.norm();
    if (length > 0) n /= length;
  }
  return normals;
}

double edge_length(const Mesh& mesh, EdgeId e) {
  const HalfedgeId h = mesh.halfedge(e);
  return (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm();
}

EdgeMap<double> edge_lengths(const Mesh& mesh) {
  EdgeMap<double> lengths(mesh.edge_count(), 0.0);
  for (EdgeId e : mesh.edges()) lengths[e] = edge_length(mesh, e);
  return lengths;
}

double mean_edge_length(const Mesh& mesh) {
  double sum = 0;
  for (EdgeId e : mesh.edges()) sum += edge_length(mesh, e);
  return sum / mesh.edge_count();
}

std::vector<Vec3> transformed(std::span<const Vec3> points, const RigidTransform& motion) {
  std::vector<Vec3> moved;
  moved.reserve(points.size());
  for (const Vec3& p : points) moved.push_back(motion * p);
  return moved;
}

Mesh transformed(const Mesh& mesh, const RigidTransform& motion) {
  return mesh.with_positions(transformed(mesh.positions(), motion));
}

Mesh reversed(const Mesh& mesh) {
  TriangleSoup soup = mesh.soup();
  for (auto& t : soup.triangles) std::swap(t[1], t[2]);
  return build_mesh(std::move(soup));
}

}  // namespace foramen
