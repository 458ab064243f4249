#pragma once
/// \file
/// More landmarks where those there are miss a shape.

#include <span>

#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/sampling/sampling_options.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "sampling/remesh.hpp"
#include "sampling/torus_grid.hpp"

namespace foramen {

/// A shape that landmarks stand for.
struct RepresentedShape {
  const Mesh* input = nullptr;
  const VertexMap<Vec2>* turns = nullptr;  ///< torus positions of the input's vertices
  std::vector<Vec3> landmarks;             ///< on the input surface, same coordinates
};

/// The density times max(1, error / accepted)^exponent, the error at a point of the grid being the largest
/// distance of a shape's input vertices there to the mesh of its landmarks, over all shapes, spread and
/// smoothed. The error of a triangulation falls with the square of its edges, so inversely with the density.
/// \param density  per point of the grid. The same for any number of threads.
VertexMap<double> raised_by_error(const VertexMap<double>& density, const TorusGrid& grid,
                                  std::span<const RepresentedShape> shapes,
                                  const std::vector<std::array<int, 3>>& triangles, const RunContext& ctx,
                                  const ErrorDensityOptions& options = {});

}  // namespace foramen
