#pragma once
/// \file
/// Meshes from matrices of vertices and faces, and back.

#include <Eigen/Core>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// \param points  one row per vertex, mm  \param triangles  one row per face: indices of its corners,
/// counter-clockwise seen from outside
/// Throws what build_mesh() throws.
Mesh mesh_from_matrices(const Eigen::Ref<const Eigen::MatrixX3d>& points,
                        const Eigen::Ref<const Eigen::MatrixX3i>& triangles);

/// One row per point.
Eigen::MatrixX3d matrix_of(std::span<const Vec3> points);
/// One row per triangle.
Eigen::MatrixX3i matrix_of(std::span<const std::array<int, 3>> triangles);

}  // namespace foramen
