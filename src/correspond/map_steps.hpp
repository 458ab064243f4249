#pragma once
/// \file
/// Private to correspond: the steps that every registration of a shape takes, whatever draws its map.

#include <functional>

#include "foramen/correspond/register_shape.hpp"
#include "simplify/working_mesh.hpp"

namespace foramen {

/// first_map() with the reference's loops, in the reference's lattice and moved onto its place
/// (translated_onto()).
FirstMap placed_first_map(const Mesh& carried, const Mesh& embedded, const Reference& reference,
                          InitialMap initial_map, EdgeCost edge_cost);

/// The map of the input mesh: the working mesh's map is refined, optimised on the input mesh and certified.
/// Throws ConvergenceError if either search ended at its limit or the map is not one to one.
/// \param optimise  the search on the input mesh from a start
ShapeMap finished_map(const Mesh& input, const WorkingMesh& working, const OptimisedMap& coarse,
                      const std::function<OptimisedMap(const TorusMap& start)>& optimise);

/// Checks a finished map against the reference: its homology (require_reference_homology()) and its
/// direction. Returns map_agreement(). Throws TopologyError.
/// \param input  in its own coordinates  \param to_reference  its rigid alignment
Vec2 require_map_like_reference(const Mesh& input, const RigidTransform& to_reference, const TorusMap& map,
                                const Reference& reference);

}  // namespace foramen
