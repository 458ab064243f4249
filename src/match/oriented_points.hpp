#pragma once
/// \file
/// Points of a surface with the normals there, and the search among them.

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
};

OrientedPoint moved(const OrientedPoint& point, const RigidTransform& motion);

/// The direction between two normals; the second where they are opposed.
Vec3 mean_normal(const Vec3& a, const Vec3& b);

/// The vertices of a surface. \param normals  of the vertices
std::vector<OrientedPoint> oriented_vertices(const Mesh& mesh, const VertexMap<Vec3>& normals);
std::vector<OrientedPoint> oriented_vertices(const Mesh& mesh);

/// `count` points spread evenly over a surface by sample_surface(), each with the normals of its triangle's
/// vertices interpolated. The samples of a surface that was moved are the moved samples, to rounding.
/// \param normals  of the vertices  \param seed  of the random draws
std::vector<OrientedPoint> oriented_samples(const Mesh& mesh, const VertexMap<Vec3>& normals, int count,
                                            std::uint64_t seed);
std::vector<OrientedPoint> oriented_samples(const Mesh& mesh, int count, std::uint64_t seed);

/// Oriented points, and the search for the nearest by position and normal together: see OrientedPointIndex.
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

/// For each vertex of `from` the nearest vertex of `to` by position and normal, with the weight of normals
/// that serves vertebrae.
VertexMap<VertexId> nearest_vertices(const Mesh& from, const Mesh& to);

}  // namespace foramen
