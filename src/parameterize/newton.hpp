#pragma once
/// \file
/// Projected Newton on the map energy.

#include "foramen/core/run_context.hpp"
#include "parameterize/map_energy.hpp"
#include "parameterize/optimise_map.hpp"

namespace foramen {

/// The result of a minimisation by either method.
struct Minimisation {
  MapState state;
  OptimiseStatus status = OptimiseStatus::iteration_limit;
  std::vector<double> energies;  ///< initial energy, then the energy after each iteration
};

Minimisation minimise_by_newton(const MapEnergy& energy, MapState start, const RunContext& ctx,
                                const OptimiseMapOptions& options);

/// Whether the energy has reached options.stop_at_energy.
inline bool low_enough(double energy, const OptimiseMapOptions& options) {
  return options.stop_at_energy && energy <= *options.stop_at_energy;
}

}  // namespace foramen
