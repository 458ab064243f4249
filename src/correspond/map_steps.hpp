#pragma once
/// \file
/// Private to correspond: the steps of a registration that do not depend on its correspondence energy.

#include <functional>

#include "correspond/first_map.hpp"
#include "correspond/register_shape.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "parameterize/optimise_map.hpp"
#include "simplify/working_mesh.hpp"

namespace foramen {

/// Throws TopologyError, which says the genus, for a surface that is not one closed piece of genus 1. The
/// steps that follow would refuse it late and in their own terms.
void require_genus_one(const Mesh& surface);

/// first_map() with the reference's loops, in the reference's lattice and moved onto its place
/// (translated_onto()).
FirstMap placed_first_map(const Mesh& carried, const Mesh& embedded, const Reference& reference,
                          InitialMap initial_map, EdgeCost edge_cost);

/// The map of the input mesh: the working mesh's map is refined, optimised on the input mesh and certified.
/// Throws ConvergenceError if either search ended at its limit or the map is not one to one.
/// \param optimise  the optimisation on the input mesh from a start map
ShapeMap finished_map(const Mesh& input, const WorkingMesh& working, const OptimisedMap& coarse,
                      const std::function<OptimisedMap(const TorusMap& start)>& optimise);

/// Checks a finished map against the reference: its homology (require_reference_homology()) and its
/// direction. Returns map_agreement(). Throws TopologyError.
/// \param input  the shape in its own coordinates
/// \param to_reference  its rigid alignment to the reference
Vec2 require_map_like_reference(const Mesh& input, const RigidTransform& to_reference, const TorusMap& map,
                                const Reference& reference);

}  // namespace foramen
