#include "landmarks/landmarks_by_icp.hpp"

#include "core/parallel.hpp"
#include "correspond/icp_baseline.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "sampling/curvature_density.hpp"
#include "sampling/lift_to_surface.hpp"
#include "sampling/remesh.hpp"

namespace foramen {
namespace {

VertexMap<Vec3> normals_of(const std::vector<Vec3>& landmarks, const LandmarkMesh& mesh) {
  return vertex_normals(build_mesh({landmarks, mesh.triangles}));
}

}  // namespace

Landmarks landmarks_by_icp(const std::vector<Mesh>& shapes, const CohortRegistration& cohort,
                           const PlaceLandmarksOptions& options, const RunContext& ctx) {
  const Mesh& reference = cohort.frame.reference.mesh();
  const TorusMap& map = cohort.frame.reference.shape_map.map;
  Landmarks result;
  result.mesh = remesh(reference, map, curvature_density(reference, options.spread.density), ctx,
                       {.landmarks = options.count, .relaxation_rounds = options.spread.relaxation_rounds});

  const std::vector<Vec3> on_reference = lift_to_surface(TorusLocator(reference, map), result.mesh.turns);
  const VertexMap<Vec3> normals = normals_of(on_reference, result.mesh);
  result.points.resize(shapes.size());
  result.without_compatible.resize(shapes.size());
  parallel_for(static_cast<int>(shapes.size()), ctx, [&](int i) {
    const std::size_t k = i;
    if (i == cohort.reference) {
      result.points[k] = on_reference;
      return;
    }
    IcpCorrespondence carried = icp_correspondence(on_reference, normals.values(), TriangleTree(shapes[k]),
                                                   cohort.shapes[k].alignment.transform);
    result.points[k] = std::move(carried.points);
    result.without_compatible[k] = carried.without_compatible;
  });
  return result;
}

std::vector<Vec3> newcomers_landmarks_by_icp(const Mesh& shape, const CohortRegistration& cohort,
                                             const Landmarks& landmarks, const RunContext& ctx) {
  const std::vector<Vec3>& on_reference = landmarks.points[cohort.reference];
  return icp_correspondence(on_reference, normals_of(on_reference, landmarks.mesh).values(),
                            TriangleTree(shape), align(shape, cohort.frame.reference.mesh(), ctx).transform)
      .points;
}

}  // namespace foramen
