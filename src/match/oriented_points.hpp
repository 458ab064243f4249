#pragma once
/// \file
/// Points of a surface with normals, and nearest-point search among them.

#include <cstdint>
#include <vector>

#include "foramen/core/geometry.hpp"
#include "spatial/point_index.hpp"

namespace foramen {

/// A point of a surface.
struct OrientedPoint {
  Vec3 position;           ///< mm
  Vec3 normal;             ///< unit, outward
  bool at_border = false;  ///< Whether its triangle has a vertex on an open border of the surface.
  double curvedness = 0;   ///< curvedness() of the surface there; 0 where it is not used
};

/// The point and its normal moved by a rigid transform.
OrientedPoint moved(const OrientedPoint& point, const RigidTransform& motion);

/// The normalised mean of two normals; the second one if they are opposite.
Vec3 mean_normal(const Vec3& a, const Vec3& b);

/// The vertices of a surface with their normals.
/// \param normals  normals of the vertices
std::vector<OrientedPoint> oriented_vertices(const Mesh& mesh, const VertexMap<Vec3>& normals);
std::vector<OrientedPoint> oriented_vertices(const Mesh& mesh);

/// `count` points of a surface, stratified by area (sample_surface()), with normals interpolated from the
/// vertices. Up to rounding, the samples of a moved surface are the moved samples of the surface.
/// \param vertices  oriented_vertices() of the mesh; their curvedness is interpolated too
/// \param seed  seed of the random draws
std::vector<OrientedPoint> oriented_samples(const Mesh& mesh, const std::vector<OrientedPoint>& vertices,
                                            int count, std::uint64_t seed);
std::vector<OrientedPoint> oriented_samples(const Mesh& mesh, const VertexMap<Vec3>& normals, int count,
                                            std::uint64_t seed);
std::vector<OrientedPoint> oriented_samples(const Mesh& mesh, int count, std::uint64_t seed);

/// Oriented points with an index for nearest-point search by position and normal (OrientedPointIndex).
class IndexedPoints {
 public:
  /// \param normal_weight  mm per unit of normal difference. >= 0.
  IndexedPoints(std::vector<OrientedPoint> points, double normal_weight);
  const std::vector<OrientedPoint>& points() const { return points_; }
  const OrientedPoint& operator[](int index) const { return points_[index]; }
  NearPoint nearest(const OrientedPoint& query) const;
  /// The `count` nearest, nearest first (fewer if there are fewer points).
  std::vector<NearPoint> nearest(const OrientedPoint& query, int count) const;

 private:
  std::vector<OrientedPoint> points_;
  OrientedPointIndex index_;
};

/// For each vertex of `from` the nearest vertex of `to` by position and normal, with the weight
/// vertebra_normal_weight_mm.
VertexMap<VertexId> nearest_vertices(const Mesh& from, const Mesh& to);

}  // namespace foramen
