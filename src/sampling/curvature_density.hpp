#pragma once
/// \file
/// How densely a surface is to be sampled: more where it is curved.

#include "foramen/core/mesh.hpp"
#include "foramen/core/options.hpp"
#include "foramen/sampling/sampling_options.hpp"

namespace foramen {

/// \f$ ((|K| + H^2) / 2)^{contrast} \f$ per vertex, \cite fuhrmann2010, clamped at the 99 % quantile of the
/// curvature, scaled to a largest value of 1, raised to the floor, smoothed. K and H come from the
/// normal-cycle curvature tensor (\cite cohensteiner2003) averaged over options.curvature_radius, in which
/// the steps of a voxel surface cancel.
VertexMap<double> curvature_density(const Mesh& surface, const CurvatureDensityOptions& options = {});

}  // namespace foramen
