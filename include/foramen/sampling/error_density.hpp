#pragma once
/// \file
/// A density of landmarks that is raised where the present landmarks represent a shape badly.

#include <span>

#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/sampling/remesh.hpp"
#include "foramen/sampling/torus_grid.hpp"
#include "foramen/spatial/triangle_tree.hpp"

namespace foramen {

/// A shape and the landmarks that represent it.
struct RepresentedShape {
  const Mesh* input = nullptr;
  const VertexMap<Vec2>* turns = nullptr;  ///< torus positions of the input's vertices
  std::vector<Vec3> landmarks;             ///< positions on the input surface, in its coordinates
};

struct ErrorDensityOptions {
  double accepted_mm = 0.5;
  double exponent = 1.0;
  int spread_rings = 3;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<ErrorDensityOptions> auto& o) {
  visit(o.accepted_mm,
        {.name = "accepted_error",
         .unit = "mm",
         .range = above(0),
         .meaning = "distance between a shape and its landmarks up to which no landmarks are added"});
  visit(
      o.exponent,
      {.name = "error_exponent",
       .range = at_least(0),
       .meaning = "an error of r times the accepted one raises the density of landmarks by r to this power"});
  visit(o.spread_rings, {.name = "error_spread_rings",
                         .range = at_least(0),
                         .meaning = "rings of grid points that an error reaches"});
}

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
