#include "sampling/remesh.hpp"

#include <string>

#include "foramen/core/error.hpp"
#include "sampling/delaunay_flips.hpp"
#include "sampling/landmark_state.hpp"
#include "sampling/lloyd.hpp"
#include "sampling/thin_out.hpp"

namespace foramen {
namespace {

void check(const Mesh& surface, const TorusMap& map, const VertexMap<double>& density,
           const RemeshOptions& options) {
  FORAMEN_ASSERT(map.turns.size() == surface.vertex_count() && density.size() == surface.vertex_count());
  check_options("remesh", options);
  for (VertexId v : surface.vertices())
    if (!(density[v] > 0))
      throw InvalidInput("remesh: the density of vertex " + std::to_string(v.index) + " is not positive");
}

/// The state without the slots of removed vertices and faces.
detail::LandmarkState compacted(const detail::LandmarkState& all, const detail::DenseSurface& surface) {
  const LandmarkMesh live = all.mesh.landmark_mesh();
  detail::LandmarkState out{detail::TorusTriangulation(live.turns, live.triangles, live.jumps),
                            std::vector<Vec3>(live.turns.size()), std::vector<double>(live.turns.size())};
  for (int v = 0; v < out.mesh.vertex_slots(); ++v) out.update(v, surface);
  return out;
}

}  // namespace

LandmarkMesh remesh(const Mesh& surface, const TorusMap& map, const VertexMap<double>& density,
                    const RunContext& ctx, const RemeshOptions& options) {
  check(surface, map, density, options);
  const detail::DenseSurface dense(surface, map, density);
  const auto points = surface.positions();
  detail::LandmarkState landmarks{detail::TorusTriangulation(surface, map),
                                  std::vector<Vec3>(points.begin(), points.end()), density.values()};
  detail::thin_out(landmarks, options.landmarks, ctx);
  landmarks = compacted(landmarks, dense);
  detail::fill_up(landmarks, options.landmarks, dense, ctx);
  for (int round = 0; round < options.relaxation_rounds; ++round) {
    ctx.step("remesh", double(round) / options.relaxation_rounds);
    detail::delaunay_flips(landmarks, ctx);
    detail::lloyd_round(landmarks, dense, ctx);
  }
  detail::delaunay_flips(landmarks, ctx);
  return landmarks.mesh.landmark_mesh();
}

}  // namespace foramen
