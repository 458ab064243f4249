#pragma once
/// \file
/// Node-wise descent, the paper's way: every node in turn moves inside the kernel of its one-ring.

#include "parameterize/newton.hpp"
#include "parameterize/optimise_map.hpp"

namespace foramen {

/// Sweeps over all nodes by index. Each minimises the terms that it takes part in (its E_cor and the E of its
/// triangles, with the weights of the whole energy) by a few steps of nonlinear conjugate gradients (Polak
/// and Ribiere).
Minimisation minimise_by_sweeps(const MapEnergy& energy, MapState start, const RunContext& ctx,
                                const OptimiseMapOptions& options);

}  // namespace foramen
