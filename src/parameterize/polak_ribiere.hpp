#pragma once
/// \file
/// Node-wise descent as in the paper: the nodes move one after another inside the kernels of their one-rings.

#include "parameterize/newton.hpp"
#include "parameterize/optimise_map.hpp"

namespace foramen {

/// Sweeps over all nodes in order of index. For each node, its own terms of the energy (its E_cor and the E
/// of its triangles, with the weights of the whole energy) are decreased by a few steps of nonlinear
/// conjugate gradients (Polak and Ribiere).
Minimisation minimise_by_sweeps(const MapEnergy& energy, MapState start, const RunContext& ctx,
                                const OptimiseMapOptions& options);

}  // namespace foramen
