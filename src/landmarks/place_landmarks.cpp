#include "foramen/landmarks/place_landmarks.hpp"

#include <utility>

#include "correspond/register_group.hpp"
#include "correspond/register_shape.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "landmarks/landmarks_by_icp.hpp"
#include "landmarks/landmarks_by_torus.hpp"
#include "sampling/lift_to_surface.hpp"

namespace foramen {

Landmarks place_landmarks(std::span<const Shape> shapes, Correspondence correspondence,
                          const PlaceLandmarksOptions& options, const RunContext& ctx) {
  check_options("place_landmarks", options);
  std::vector<Mesh> meshes;
  std::vector<std::string> names;
  for (const ShapeRegistration& shape : correspondence.registration.shapes) {
    names.push_back(shape.name);
    meshes.push_back(shape_named(shapes, shape.name).mesh);
  }
  const CohortRegistration& cohort = correspondence.registration;
  Landmarks landmarks = cohort.method == Method::icp
                            ? landmarks_by_icp(meshes, cohort, options, ctx)
                            : landmarks_by_torus(meshes, std::move(correspondence.maps), options, ctx);
  landmarks.names = std::move(names);
  return landmarks;
}

std::vector<Vec3> landmarks_on_newcomer(const Mesh& shape, const CohortRegistration& cohort,
                                        const Landmarks& landmarks, const CorrespondOptions& options,
                                        const RunContext& ctx) {
  if (options.method == Method::icp) return newcomers_landmarks_by_icp(shape, cohort, landmarks, ctx);
  const RegistrationFrame& frame = cohort.frame;
  const RegisteredShape registered =
      options.objective == Objective::surface
          ? register_to_group(shape, frame.reference, frame.group, ctx, options.group)
          : register_shape(shape, frame.reference, ctx, options.registration);
  return lift_to_surface(TorusLocator(shape, registered.shape_map.map), landmarks.mesh.turns);
}

}  // namespace foramen
