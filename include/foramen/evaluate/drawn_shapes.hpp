#pragma once
/// \file
/// Whether the shapes that a model describes are valid surfaces.

#include <cstdint>
#include <vector>

#include "foramen/core/run_context.hpp"
#include "foramen/evaluate/cohort.hpp"

namespace foramen {

/// Limit of the scores of drawn shapes, in standard deviations of each mode: the range in which models are
/// commonly used.
inline constexpr double largest_drawn_sd = 2;

struct DrawnShapesOptions {
  int draws = 1000;        ///< > 0
  std::uint64_t seed = 1;  ///< seed of the draws
};

/// Numbers of defects of one drawn shape.
struct DrawnShape {
  int self_intersections = 0;  ///< pairs of triangles, see self_intersections()
  int folded = 0;              ///< triangles, see folded_over()
  int opposing_mean = 0;       ///< triangles, see opposing_mean()
};

/// The defects of all drawn shapes.
struct DrawnShapes {
  std::vector<DrawnShape> draws;
  Estimate self_intersecting;  ///< share of draws with a self-intersection, 0 .. 1
  Estimate folded;             ///< share of draws with a folded triangle, 0 .. 1
  Estimate opposing_mean;      ///< share of draws with a triangle that opposes that of the mean, 0 .. 1
};

/// Draws shapes \f$ \bar x + \sum_m b_m \phi_m \f$ with all modes and counts defects of their surfaces. The
/// scores are b_m ~ N(0, variance_m) under the condition |b_m| <= largest_drawn_sd standard deviations (a
/// larger score is drawn again). The training shapes are not used. Each draw has its own random stream, so
/// the result does not depend on the number of threads. Throws InvalidInput if options.draws is not > 0.
DrawnShapes drawn_shapes(const ShapeModel& model, const DrawnShapesOptions& options, const RunContext& ctx);

}  // namespace foramen
