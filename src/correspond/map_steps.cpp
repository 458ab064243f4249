#include "correspond/map_steps.hpp"

#include <optional>
#include <string>
#include <utility>

#include "correspond/first_map.hpp"
#include "correspond/shape_map.hpp"
#include "correspond/transfer_homology.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "foramen/topology/inspect_mesh.hpp"
#include "parameterize/optimise_map.hpp"
#include "parameterize/refine_map.hpp"

namespace foramen {

void require_genus_one(const Mesh& surface) {
  const std::optional<int> genus = inspect_mesh(surface.soup()).genus;
  if (!genus) throw TopologyError("the surface is not closed or not in one piece, so that it has no genus");
  if (*genus != 1)
    throw TopologyError("the surface has genus " + std::to_string(*genus) + "; it must have genus 1");
}

FirstMap placed_first_map(const Mesh& carried, const Mesh& embedded, const Reference& reference,
                          InitialMap initial_map, EdgeCost edge_cost) {
  const TorusMap& reference_map = reference.shape_map.map;
  FirstMap first = first_map(carried, embedded, reference.loops, initial_map, edge_cost);
  first.map.lattice = reference_map.lattice;
  first.map = translated_onto(std::move(first.map), carried, reference.mesh(), reference_map);
  return first;
}

ShapeMap finished_map(const Mesh& input, const WorkingMesh& working, const OptimisedMap& coarse,
                      const std::function<OptimisedMap(const TorusMap& start)>& optimise) {
  require_converged(coarse, "working");
  const OptimisedMap full = optimise(refine_map(input, working, coarse.map));
  require_converged(full, "input");
  return certified(input, coarse, full);
}

Vec2 require_map_like_reference(const Mesh& input, const RigidTransform& to_reference, const TorusMap& map,
                                const Reference& reference) {
  const TorusMap& reference_map = reference.shape_map.map;
  require_reference_homology(input, map, reference_map.turns[reference.loops.loops.basepoint],
                             reference.loops.seifert);
  Vec2 agreement = map_agreement(transformed(input, to_reference), map, reference.mesh(), reference_map);
  if (agreement.minCoeff() <= 0)
    throw TopologyError(
        "the map of this shape runs against the reference's (the loops' directions disagree)");
  return agreement;
}

}  // namespace foramen
