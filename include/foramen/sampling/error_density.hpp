#pragma once
/// \file
/// More landmarks where those there are miss a shape.

#include <span>

#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/sampling/remesh.hpp"
#include "foramen/sampling/torus_grid.hpp"
#include "foramen/spatial/triangle_tree.hpp"

namespace foramen {

/// A shape that landmarks stand for.
struct RepresentedShape {
  const Mesh* input = nullptr;
  const VertexMap<Vec2>* turns = nullptr;  ///< torus positions of the input's vertices
  std::vector<Vec3> landmarks;             ///< on the input surface, same coordinates
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

/// The density times max(1, error / accepted)^exponent, the error at a point of the grid being the largest
/// distance of a shape's input vertices there to the mesh of its landmarks, over all shapes, spread and
/// smoothed. The error of a triangulation falls with the square of its edges, so inversely with the density.
/// \param density  per point of the grid. The same for any number of threads.
VertexMap<double> raised_by_error(const VertexMap<double>& density, const TorusGrid& grid,
                                  std::span<const RepresentedShape> shapes,
                                  const std::vector<std::array<int, 3>>& triangles, const RunContext& ctx,
                                  const ErrorDensityOptions& options = {});

}  // namespace foramen
