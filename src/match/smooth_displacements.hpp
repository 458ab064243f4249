#pragma once
/// \file
/// Smooth displacements of a surface: a Gaussian process in space, in a basis of low rank.

#include <span>
#include <vector>

#include <Eigen/Core>

#include "foramen/core/mesh.hpp"
#include "foramen/core/options.hpp"
#include "foramen/match/bending_options.hpp"

namespace foramen {

/// Functions phi_k over the points such that sum_k phi_k(x) phi_k(y) is the covariance of a coordinate of the
/// displacement at x and y: u = phi a with independent standard normal a is a draw, and |a|^2 / 2 its
/// negative log density. One row per point, one column per function. The process lives in space, so the two
/// sides of a thin wall move together, and what slides along a featureless wall is decided by what lies
/// around it. Pivoted Cholesky factorisation of the kernel matrix \cite harbrecht2012, as for the Gaussian
/// process morphable models of \cite luethi2018. Throws InvalidInput for options out of range.
Eigen::MatrixXd smooth_displacements(std::span<const Vec3> points,
                                     const SmoothDisplacementOptions& options = {});

}  // namespace foramen
