#include "correspond/first_map.hpp"

#include <cmath>
#include <numbers>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "match/oriented_points.hpp"
#include "parameterize/initial_map.hpp"
#include "topology/linking.hpp"
#include "topology/periods.hpp"

namespace foramen {

FirstMap first_map(const Mesh& carried, const Mesh& embedded, const ReferenceLoops& reference,
                   InitialMap initial_map, EdgeCost edge_cost) {
  const LoopSystem loops = propagate_loops(carried, reference, edge_cost);
  const Cocycle form = cocycle(carried, loops);
  FirstMap first;
  first.homology = transfer_homology(carried, form, reference).a;
  first.seifert = seifert_matrix(embedded, loops.loops[0], loops.loops[1]);
  if (!seifert_test(first.homology, first.seifert, reference.seifert))
    throw TopologyError(
        "the reference's loops were carried to loops of another class on this shape (Seifert test failed): "
        "the shape is probably misaligned or of another anatomy");
  const TorusMap unnamed = initial_map == InitialMap::torus ? harmonic_torus_map(carried, form)
                                                            : rectangle_torus_map(carried, loops);
  first.map = change_basis(unnamed, inverse_unimodular(first.homology));
  return first;
}

TorusMap translated_onto(TorusMap map, const Mesh& carried, const Mesh& reference,
                         const TorusMap& reference_map) {
  const VertexMap<VertexId> near = nearest_vertices(carried, reference);
  const auto areas = vertex_areas(carried);
  Vec2 cosine = Vec2::Zero(), sine = Vec2::Zero();
  for (VertexId v : carried.vertices()) {
    const Vec2 difference = 2 * std::numbers::pi * (reference_map.turns[near[v]] - map.turns[v]);
    cosine += areas[v] * difference.array().cos().matrix();
    sine += areas[v] * difference.array().sin().matrix();
  }
  const Vec2 shift =
      Vec2(std::atan2(sine.x(), cosine.x()), std::atan2(sine.y(), cosine.y())) / (2 * std::numbers::pi);
  for (Vec2& p : map.turns) p += shift;
  return map;
}

}  // namespace foramen
