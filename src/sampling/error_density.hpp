#pragma once
/// \file
/// A density of landmarks that is raised where the present landmarks represent a shape badly.

#include <span>

#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "sampling/remesh.hpp"
#include "sampling/torus_grid.hpp"

namespace foramen {

/// A shape and the landmarks that represent it.
struct RepresentedShape {
  const Mesh* input = nullptr;
  const VertexMap<Vec2>* turns = nullptr;  ///< torus positions of the input's vertices
  std::vector<Vec3> landmarks;             ///< positions on the input surface, in its coordinates
};

/// Returns density * max(1, error / accepted_mm)^exponent at each point of the grid. The error at a point is
/// the largest distance, over all shapes, between the input vertices at this point and the mesh of the
/// shape's landmarks. The error is spread to neighbouring grid points and the factor is smoothed. The
/// exponent 1 follows from the error of a triangulation, which is proportional to the square of its edge
/// lengths and so inversely proportional to the density. The result does not depend on the number of threads.
/// Throws InvalidInput for options out of range.
/// \param density  one value per point of the grid
VertexMap<double> raised_by_error(const VertexMap<double>& density, const TorusGrid& grid,
                                  std::span<const RepresentedShape> shapes,
                                  const std::vector<std::array<int, 3>>& triangles, const RunContext& ctx,
                                  const ErrorDensityOptions& options = {});

}  // namespace foramen
