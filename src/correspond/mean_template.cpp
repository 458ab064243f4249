#include "correspond/mean_template.hpp"

#include <utility>

#include "core/parallel.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "sampling/curvature_density.hpp"
#include "sampling/remesh.hpp"
#include "sampling/torus_grid.hpp"

namespace foramen {

TemplateSurface remeshed_template(const Mesh& surface, const TorusMap& map, int vertices,
                                  const RunContext& ctx) {
  LandmarkMesh landmarks = remesh(surface, map, curvature_density(surface), ctx, {.landmarks = vertices});
  const TorusLocator locator(surface, map);
  TemplateSurface result;
  result.mesh = build_mesh({lift_to_surface(locator, landmarks.turns), std::move(landmarks.triangles)});
  result.map = {map.lattice, VertexMap<Vec2>(std::move(landmarks.turns)), std::move(landmarks.jumps)};
  return result;
}

MeanTemplate mean_template(std::span<const TorusLocator* const> shapes, const Lattice& lattice,
                           const RunContext& ctx, const TemplateOptions& options) {
  const TorusGrid grid = make_torus_grid(lattice, options.grid_points);
  std::vector<std::vector<Vec3>> lifted(shapes.size());
  parallel_for(static_cast<int>(shapes.size()), ctx,
               [&](int i) { lifted[i] = lift_to_surface(*shapes[i], grid.turns); });
  ProcrustesResult mean = procrustes(lifted, ScaleMode::keep);
  const Mesh surface = build_mesh({mean.mean, grid.triangles});
  const TorusMap map{lattice, VertexMap<Vec2>(grid.turns), grid.jumps};
  return {remeshed_template(surface, map, options.vertices, ctx), std::move(mean.transforms),
          std::move(mean.mean)};
}

}  // namespace foramen
