#pragma once
/// \file
/// Converts between meshes and Eigen matrices of vertices and faces.

#include <Eigen/Core>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// Builds a mesh from matrices. Throws what build_mesh() throws.
/// \param points  one row per vertex, mm
/// \param triangles  one row per face: the indices of its corners, counter-clockwise seen from outside
Mesh mesh_from_matrices(const Eigen::Ref<const Eigen::MatrixX3d>& points,
                        const Eigen::Ref<const Eigen::MatrixX3i>& triangles);

/// Returns one row per point.
Eigen::MatrixX3d matrix_of(std::span<const Vec3> points);
/// Returns one row per triangle.
Eigen::MatrixX3i matrix_of(std::span<const std::array<int, 3>> triangles);

}  // namespace foramen
