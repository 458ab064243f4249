#pragma once
/// \file
/// Smooth displacements of a surface: a Gaussian process in space in a low-rank basis.

#include <span>
#include <vector>

#include <Eigen/Core>

#include "foramen/core/mesh.hpp"
#include "foramen/core/options.hpp"

namespace foramen {

/// One term of the covariance of each coordinate: amplitude^2 exp(-r^2 / (2 length^2)).
struct DisplacementScale {
  double length_mm = 10;
  double amplitude_mm = 1;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<DisplacementScale> auto& o) {
  visit(o.length_mm, {.name = "length",
                      .unit = "mm",
                      .range = above(0),
                      .meaning = "distance over which displacements are alike"});
  visit(o.amplitude_mm, {.name = "amplitude",
                         .unit = "mm",
                         .range = above(0),
                         .meaning = "standard deviation of a coordinate"});
}

struct SmoothDisplacementOptions {
  /// From displacements of large parts of a vertebra to displacements of the tip of a process.
  std::vector<DisplacementScale> scales = {{40, 4}, {20, 1.5}, {10, 0.5}};
  double shift_mm = 10;
  double linear_mm = 6;
  double left_out_mm = 0.3;
  int most_functions = 400;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<SmoothDisplacementOptions> auto& o) {
  visit(o.scales, {.name = "scales", .meaning = "parts of the covariance"});
  visit(o.shift_mm, {.name = "shift",
                     .unit = "mm",
                     .range = above(0),
                     .meaning = "standard deviation of a common translation"});
  visit(o.linear_mm,
        {.name = "linear",
         .unit = "mm",
         .range = above(0),
         .meaning = "standard deviation of a linear map's displacement at the surface's RMS radius"});
  visit(o.left_out_mm,
        {.name = "left_out",
         .unit = "mm",
         .range = above(0),
         .meaning = "the basis ends when no point's standard deviation left out is above this"});
  visit(o.most_functions,
        {.name = "functions_limit", .range = at_least(1), .meaning = "most functions of the basis"});
}

/// Returns the values of basis functions phi_k, mm: one row per point and one column per function. The sum of
/// phi_k(x) phi_k(y) over k is the covariance of one coordinate of the displacement at x and y. With
/// independent standard normal coefficients a, u = phi a is a sample of the process, and |a|^2 / 2 is its
/// negative log density up to a constant.
///
/// The process is defined in space, so the two sides of a thin wall move together, and displacements along a
/// featureless wall follow those of the surrounding surface. The basis is computed by pivoted Cholesky
/// factorisation of the kernel matrix \cite harbrecht2012, as for the Gaussian process morphable models of
/// \cite luethi2018. Throws InvalidInput for options out of range.
Eigen::MatrixXd smooth_displacements(std::span<const Vec3> points,
                                     const SmoothDisplacementOptions& options = {});

}  // namespace foramen
