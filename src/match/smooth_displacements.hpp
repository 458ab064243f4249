#pragma once
/// \file
/// Smooth displacements of a surface: a Gaussian process in space in a low-rank basis.

#include <span>
#include <vector>

#include <Eigen/Core>

#include "foramen/core/mesh.hpp"
#include "foramen/core/options.hpp"
#include "foramen/match/bending_options.hpp"

namespace foramen {

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
