#include "correspond/propagate_loops.hpp"

#include <algorithm>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "spatial/point_index.hpp"
#include "topology/linking.hpp"
#include "topology/periods.hpp"

namespace foramen {
namespace {

// Keeps the length-weighted cost of edges on the reference loops positive.
constexpr double smallest_distance_mm = 0.5;

EdgeLoop reversed_loop(const Mesh& mesh, const EdgeLoop& loop) {
  EdgeLoop back;
  back.reserve(loop.size());
  for (auto h = loop.rbegin(); h != loop.rend(); ++h) back.push_back(mesh.twin(*h));
  return back;
}

// Twice the signed area in squared turns that a map with these periods covers: exactly +2 or -2 for a basis.
int doubled_area_in_turns(const Mesh& mesh, const Cocycle& form) {
  int sum = 0;
  for (FaceId f : mesh.faces()) {
    const Vec2i a = form.value[Mesh::halfedge(f, 0)], b = form.value[Mesh::halfedge(f, 1)];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return sum;
}

}  // namespace

LoopSystem oriented(const Mesh& mesh, LoopSystem loops) {
  const int doubled = doubled_area_in_turns(mesh, cocycle(mesh, loops));
  FORAMEN_ASSERT(std::abs(doubled) == 2);
  if (doubled < 0) {
    loops.loops[1] = reversed_loop(mesh, loops.loops[1]);
    loops.generators[1] = mesh.twin(loops.generators[1]);
  }
  return loops;
}

ReferenceLoops find_reference_loops(const Mesh& mesh, const RunContext& ctx) {
  ReferenceLoops reference{mesh, oriented(mesh, shortest_loops(mesh, edge_lengths(mesh), ctx).system), {}};
  reference.seifert = seifert_matrix(mesh, reference.loops.loops[0], reference.loops.loops[1]);
  return reference;
}

EdgeMap<double> loop_edge_costs(const Mesh& aligned_shape, const ReferenceLoops& reference, EdgeCost cost) {
  std::vector<Vec3> loop_points;
  for (const EdgeLoop& loop : reference.loops.loops)
    for (HalfedgeId h : loop) loop_points.push_back(reference.mesh.position(reference.mesh.from(h)));
  const PointIndex index(loop_points);
  VertexMap<double> distance(aligned_shape.vertex_count(), 0.0);
  for (VertexId v : aligned_shape.vertices())
    distance[v] = std::sqrt(index.nearest(aligned_shape.position(v)).squared_distance);
  EdgeMap<double> costs(aligned_shape.edge_count(), 0.0);
  for (EdgeId e : aligned_shape.edges()) {
    const HalfedgeId h = aligned_shape.halfedge(e);
    const double mean =
        0.5 * (distance[aligned_shape.from(h)] + distance[aligned_shape.to(h)]);  // [becker2011 Eq. 3]
    costs[e] = cost == EdgeCost::paper ? mean : (mean + smallest_distance_mm) * edge_length(aligned_shape, e);
  }
  return costs;
}

LoopSystem propagate_loops(const Mesh& aligned_shape, const ReferenceLoops& reference, EdgeCost cost) {
  const PointIndex index(aligned_shape.positions());
  const Vec3 base = reference.mesh.position(reference.loops.basepoint);
  const VertexId basepoint(index.nearest(base).index);
  return oriented(aligned_shape,
                  greedy_loops(aligned_shape, basepoint, loop_edge_costs(aligned_shape, reference, cost)));
}

}  // namespace foramen
