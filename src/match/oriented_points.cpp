#include "match/oriented_points.hpp"

#include <utility>

#include "foramen/spatial/surface_distance.hpp"

namespace foramen {
namespace {

OrientedPointIndex index_of(const std::vector<OrientedPoint>& points, double normal_weight) {
  std::vector<Vec3> positions, normals;
  positions.reserve(points.size());
  normals.reserve(points.size());
  for (const OrientedPoint& p : points) {
    positions.push_back(p.position);
    normals.push_back(p.normal);
  }
  return {positions, normals, normal_weight};
}

}  // namespace

OrientedPoint moved(const OrientedPoint& point, const RigidTransform& motion) {
  return {motion * point.position, motion.linear() * point.normal, point.at_border, point.curvedness};
}

Vec3 mean_normal(const Vec3& a, const Vec3& b) {
  const Vec3 sum = a + b;
  return sum.isZero(1e-9) ? b : Vec3(sum.normalized());
}

std::vector<OrientedPoint> oriented_vertices(const Mesh& mesh, const VertexMap<Vec3>& normals) {
  std::vector<OrientedPoint> points;
  points.reserve(normals.values().size());
  for (VertexId v : mesh.vertices()) points.push_back({mesh.position(v), normals[v], mesh.is_boundary(v)});
  return points;
}

std::vector<OrientedPoint> oriented_vertices(const Mesh& mesh) {
  return oriented_vertices(mesh, vertex_normals(mesh));
}

std::vector<OrientedPoint> oriented_samples(const Mesh& mesh, const std::vector<OrientedPoint>& vertices,
                                            int count, std::uint64_t seed) {
  const std::vector<SurfacePoint> places = sample_surface(mesh, count, Rng(seed));
  std::vector<OrientedPoint> samples;
  samples.reserve(places.size());
  for (const SurfacePoint& place : places) {
    OrientedPoint sample{position(mesh, place), Vec3::Zero()};
    const auto corners = mesh.corners(place.face);
    for (std::size_t k = 0; k < 3; ++k) {
      const OrientedPoint& corner = vertices[corners[k].index];
      const double share = place.barycentric[static_cast<Eigen::Index>(k)];
      sample.normal += share * corner.normal;
      sample.curvedness += share * corner.curvedness;
      sample.at_border = sample.at_border || corner.at_border;
    }
    sample.normal.normalize();
    samples.push_back(sample);
  }
  return samples;
}

std::vector<OrientedPoint> oriented_samples(const Mesh& mesh, const VertexMap<Vec3>& normals, int count,
                                            std::uint64_t seed) {
  return oriented_samples(mesh, oriented_vertices(mesh, normals), count, seed);
}

std::vector<OrientedPoint> oriented_samples(const Mesh& mesh, int count, std::uint64_t seed) {
  return oriented_samples(mesh, oriented_vertices(mesh), count, seed);
}

IndexedPoints::IndexedPoints(std::vector<OrientedPoint> points, double normal_weight)
    : points_(std::move(points)), index_(index_of(points_, normal_weight)) {}

NearPoint IndexedPoints::nearest(const OrientedPoint& query) const {
  return index_.nearest(query.position, query.normal);
}

std::vector<NearPoint> IndexedPoints::nearest(const OrientedPoint& query, int count) const {
  return index_.nearest(query.position, query.normal, count);
}

VertexMap<VertexId> nearest_vertices(const Mesh& from, const Mesh& to) {
  const IndexedPoints there(oriented_vertices(to), vertebra_normal_weight_mm);
  std::vector<VertexId> nearest;
  nearest.reserve(from.vertex_count());
  for (const OrientedPoint& p : oriented_vertices(from)) nearest.emplace_back(there.nearest(p).index);
  return VertexMap<VertexId>(std::move(nearest));
}

}  // namespace foramen
