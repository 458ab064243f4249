#pragma once
/// \file
/// Lengths, areas and normals of a mesh, and rigid motions of it.

#include <Eigen/Geometry>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// A rotation followed by a translation in mm; never a reflection.
using RigidTransform = Eigen::Isometry3d;

/// An axis-parallel box.
struct BoundingBox {
  Vec3 low, high;  ///< mm
  double diagonal() const { return (high - low).norm(); }
};

/// \pre at least one point.
BoundingBox bounding_box(std::span<const Vec3> points);
/// Half the cross product of two sides: length = area, direction = outward normal.
Vec3 area_vector(const std::array<Vec3, 3>& triangle);
/// Area of a triangle, mm^2.
double area(const std::array<Vec3, 3>& triangle);
/// Unit normal; the zero vector for a triangle of zero area.
Vec3 unit_normal(const std::array<Vec3, 3>& triangle);
/// Area of a mesh, mm^2.
double total_area(const Mesh& mesh);
/// Volume enclosed by a closed mesh, positive when wound outward, mm^3.
double signed_volume(const Mesh& mesh);
/// Area-weighted centroid of the surface.
Vec3 surface_centroid(const Mesh& mesh);
/// For each vertex, one third of the summed areas of its triangles. The values sum to total_area().
VertexMap<double> vertex_areas(const Mesh& mesh);
/// Unit vertex normals: the normals of the triangles at a vertex are averaged with their angles at the vertex
/// as weights. The normal is zero only where all triangles at the vertex are degenerate.
VertexMap<Vec3> vertex_normals(const Mesh& mesh);
/// Lengths of edges, mm.
double edge_length(const Mesh& mesh, EdgeId e);
EdgeMap<double> edge_lengths(const Mesh& mesh);
double mean_edge_length(const Mesh& mesh);
/// The mesh or the points moved by a rigid transform.
Mesh transformed(const Mesh& mesh, const RigidTransform& motion);
std::vector<Vec3> transformed(std::span<const Vec3> points, const RigidTransform& motion);
/// The same surface with every triangle wound the other way.
Mesh reversed(const Mesh& mesh);

}  // namespace foramen
