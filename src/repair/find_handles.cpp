#include "foramen/repair/handles.hpp"

#include <cstdlib>
#include <numeric>
#include <string>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "repair/handle_search.hpp"
#include "repair/loop_surgery.hpp"
#include "topology/linking.hpp"
#include "topology/periods.hpp"

namespace foramen {
namespace repair_detail {
namespace {

// Largest number of basepoints that are evaluated for the shortest loop. Vertebrae need a few hundred. A
// surface whose loops are all about equally long needs all of its vertices.
constexpr int most_basepoints = 10000;

// A handle loop of a genus-1 surface: the combination of the two loops of a basis whose linking numbers with
// both loops pushed outward are 0.
EdgeLoop arch_loop(const Mesh& mesh) {
  const LoopSystem system = greedy_loops(mesh, VertexId(0), edge_lengths(mesh));
  const Eigen::Matrix2i s = seifert_matrix(mesh, system.loops[0], system.loops[1]);
  // The combination a solves a^T S = 0. S has rank 1, so its rows are multiples of one another.
  Eigen::Vector2i a(s(1, 0), -s(0, 0));
  if (a.isZero()) a = {s(1, 1), -s(0, 1)};
  const int divisor = std::gcd(a[0], a[1]);
  FORAMEN_ASSERT(divisor > 0);
  EdgeLoop walk;
  for (int k = 0; k < 2; ++k) {
    const EdgeLoop& loop = system.loops[k];
    const int times = a[k] / divisor;
    for (int i = 0; i < std::abs(times); ++i) {
      if (times > 0)
        walk.insert(walk.end(), loop.begin(), loop.end());
      else
        for (auto h = loop.rbegin(); h != loop.rend(); ++h) walk.push_back(mesh.twin(*h));
    }
  }
  return walk;
}

}  // namespace

FoundHandle shortest_handle(const Mesh& mesh, const RunContext& ctx) {
  const EdgeMap<double> lengths = edge_lengths(mesh);
  FoundHandle found;
  found.loop = shortest_loop(mesh, lengths, ctx, {.evaluation_limit = most_basepoints});
  found.crossing = shortest_crossing_loop(mesh, found.loop, lengths);
  found.handle.kind = loop_kind(mesh, found.loop);
  if (found.handle.kind == LoopKind::neither) {
    // The loop is a combination of a handle loop and a tunnel loop; the loop that crosses it may be of one
    // kind.
    std::swap(found.loop, found.crossing);
    found.handle.kind = loop_kind(mesh, found.loop);
  }
  found.handle.length_mm = loop_length(mesh, found.loop, lengths);
  found.handle.across_mm = loop_length(mesh, found.crossing, lengths);
  found.handle.position = loop_centre(mesh, found.loop);
  return found;
}

ExtraHandles extra_handles(const Mesh& mesh, const RunContext& ctx) {
  ExtraHandles extra{{}, mesh};
  while (extra.rest.euler_characteristic() < 0) {
    const FoundHandle found = shortest_handle(extra.rest, ctx);
    extra.handles.push_back(found.handle);
    extra.rest = cut_and_closed(extra.rest, found.loop);
  }
  return extra;
}

}  // namespace repair_detail

using namespace repair_detail;

Handle find_canal(const Mesh& mesh) {
  if (!mesh.is_closed() || mesh.euler_characteristic() != 0)
    throw TopologyError("the canal is sought on a closed surface of genus 1, found Euler number " +
                        std::to_string(mesh.euler_characteristic()));
  const EdgeMap<double> lengths = edge_lengths(mesh);
  const EdgeLoop round = shortest_crossing_loop(mesh, arch_loop(mesh), lengths);
  const EdgeLoop arch = shortest_crossing_loop(mesh, round, lengths);
  return {loop_kind(mesh, round), loop_length(mesh, round, lengths), loop_length(mesh, arch, lengths),
          loop_centre(mesh, round)};
}

SurfaceHandles find_handles(const Mesh& mesh, const RunContext& ctx) {
  ExtraHandles extra = extra_handles(mesh, ctx);
  return {std::move(extra.handles), find_canal(extra.rest)};
}

}  // namespace foramen
