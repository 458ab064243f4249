#pragma once
/// \file
/// The density of landmarks on a surface, which is higher where the surface is curved.

#include "foramen/core/mesh.hpp"
#include "foramen/core/options.hpp"
#include "foramen/sampling/landmark_mesh.hpp"

namespace foramen {

/// The density per vertex, dimensionless, with a largest value of about 1. It is \f$ (\kappa /
/// \kappa_{99})^{contrast} \f$ with the curvature measure \f$ \kappa = (|K| + H^2) / 2 \f$ \cite fuhrmann2010
/// and its 99 % quantile \f$ \kappa_{99} \f$, limited to the range from options.floor to 1 and then smoothed.
/// K and H come from the normal-cycle curvature tensor \cite cohensteiner2003 averaged over
/// options.curvature_radius, in which the steps of a voxel surface cancel. Throws InvalidInput for options
/// out of range and for a surface of zero area.
VertexMap<double> curvature_density(const Mesh& surface, const CurvatureDensityOptions& options = {});

}  // namespace foramen
