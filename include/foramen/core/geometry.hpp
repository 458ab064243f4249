#pragma once
/// \file
/// Lengths, areas and normals of a mesh, and rigid motions of it.

#include <Eigen/Geometry>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// A proper rigid motion, mm.
using RigidTransform = Eigen::Isometry3d;

struct BoundingBox {
  Vec3 low, high;  ///< mm
  double diagonal() const { return (high - low).norm(); }
};

/// \pre at least one point.
BoundingBox bounding_box(std::span<const Vec3> points);
/// Half the cross product of two sides: length = area, direction = outward normal.
Vec3 area_vector(const std::array<Vec3, 3>& triangle);
double area(const std::array<Vec3, 3>& triangle);
/// Unit normal; zero for a triangle without area.
Vec3 unit_normal(const std::array<Vec3, 3>& triangle);
double total_area(const Mesh& mesh);
/// Volume enclosed by a closed mesh, positive when wound outward, mm^3.
double signed_volume(const Mesh& mesh);
/// Area-weighted centroid of the surface.
Vec3 surface_centroid(const Mesh& mesh);
/// One third of the areas of the triangles at each vertex; they sum to total_area.
VertexMap<double> vertex_areas(const Mesh& mesh);
/// Unit normals, the triangles at a vertex weighted by their angle there. Zero only where all triangles are
/// degenerate.
VertexMap<Vec3> vertex_normals(const Mesh& mesh);
double edge_length(const Mesh& mesh, EdgeId e);
EdgeMap<double> edge_lengths(const Mesh& mesh);
double mean_edge_length(const Mesh& mesh);
Mesh transformed(const Mesh& mesh, const RigidTransform& motion);
std::vector<Vec3> transformed(std::span<const Vec3> points, const RigidTransform& motion);
/// The same surface with every triangle wound the other way.
Mesh reversed(const Mesh& mesh);

}  // namespace foramen
