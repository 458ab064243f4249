#pragma once
/// \file
/// Whether the shapes that a model describes are surfaces at all.

#include <cstdint>
#include <vector>

#include "foramen/core/run_context.hpp"
#include "foramen/evaluate/cohort.hpp"

namespace foramen {

/// No score of a drawn shape is further from 0 than this, in its standard deviations: what a model is usually
/// trusted with.
inline constexpr double largest_drawn_sd = 2;

struct DrawnShapesOptions {
  int draws = 1000;        ///< > 0
  std::uint64_t seed = 1;  ///< of the draws
};

struct DrawnShape {
  int self_intersections = 0;  ///< pairs of triangles, as self_intersections()
  int folded = 0;              ///< triangles, as folded_over()
  int opposing_mean = 0;       ///< triangles, as opposing_mean()
};

struct DrawnShapes {
  std::vector<DrawnShape> draws;
  Estimate self_intersecting;  ///< over draws: the share with a self-intersection, 0 .. 1
  Estimate folded;             ///< over draws: the share with a triangle folded over, 0 .. 1
  Estimate opposing_mean;      ///< over draws: the share with a triangle opposing the mean's, 0 .. 1
};

/// Of \f$ \bar x + \sum_m b_m \phi_m \f$ over all modes, b_m ~ N(0, variance_m) given |b_m| <=
/// largest_drawn_sd standard deviations (a score beyond is drawn anew), the share that is no proper surface.
/// The training set has no part in it. Each draw has its own stream: the same bytes for any number of
/// threads. Throws InvalidInput for no draws.
DrawnShapes drawn_shapes(const ShapeModel& model, const DrawnShapesOptions& options, const RunContext& ctx);

}  // namespace foramen
