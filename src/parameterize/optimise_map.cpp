#include "parameterize/optimise_map.hpp"

#include <cmath>
#include <utility>

#include <Eigen/LU>

#include "foramen/core/error.hpp"
#include "parameterize/map_energy.hpp"
#include "parameterize/newton.hpp"
#include "parameterize/polak_ribiere.hpp"

namespace foramen {

OptimisedMap optimise_map(const Mesh& mesh, const TorusMap& start, const RunContext& ctx,
                          const OptimiseMapOptions& options, const CorrespondenceObjective* objective,
                          const TargetMetric* metric) {
  const MapEnergy energy(mesh, start, options, objective, metric);
  Minimisation found = options.optimiser == Optimiser::newton
                           ? minimise_by_newton(energy, energy.state(start), ctx, options)
                           : minimise_by_sweeps(energy, energy.state(start), ctx, options);
  OptimisedMap out;
  out.map = energy.map(found.state);
  out.status = found.status;
  out.iterations = static_cast<int>(found.energies.size()) - 1;
  out.initial_energy = found.energies.front();
  out.final_energy = found.energies.back();
  out.distortion = energy.mean_distortion(found.state);
  out.energies = std::move(found.energies);
  // The surface is scaled to the domain, so the size of the domain does not change the energy.
  if (options.free_lattice) out.map.lattice /= std::sqrt(out.map.lattice.determinant());
  for (FaceId f : mesh.faces()) FORAMEN_ASSERT(signed_area(mesh, out.map, f) > 0);
  return out;
}

}  // namespace foramen
