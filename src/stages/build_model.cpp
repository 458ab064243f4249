#include "foramen/stages/build_model.hpp"

#include <chrono>

#include "core/freed_memory.hpp"
#include "correspond/template_surface.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/sampling/landmark_mesh.hpp"

namespace foramen {
namespace {

// Runs one stage, adds its time to `seconds` and returns freed memory to the system.
template <class Stage>
auto timed(double& seconds, const Stage& stage) {
  const auto start = std::chrono::steady_clock::now();
  auto result = stage();
  return_freed_memory();
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace

BuiltModel build_model(std::span<const Shape> shapes, const BuildOptions& options, const RunContext& ctx) {
  double correspond_seconds = 0, landmark_seconds = 0, model_seconds = 0;
  Correspondence correspondence =
      timed(correspond_seconds, [&] { return correspond(shapes, options.correspondence, ctx); });
  BuiltModel built;
  built.registration = correspondence.registration;
  ctx.step("resample", 0);
  built.landmarks = timed(landmark_seconds, [&] {
    return place_landmarks(shapes, std::move(correspondence), options.landmarks, ctx);
  });
  ctx.step("model", 0);
  built.aligned = timed(model_seconds, [&] {
    return build_shape_model(built.landmarks.points, built.landmarks.mesh.triangles, options.model);
  });
  const double reference_seconds = built.registration.reference_seconds;
  built.stage_seconds = {{"reference", reference_seconds},
                         {"register", correspond_seconds - reference_seconds},
                         {"resample", landmark_seconds},
                         {"model", model_seconds}};
  return built;
}

TemplateSurface mean_surface(const BuiltModel& built) {
  const LandmarkMesh& landmarks = built.landmarks.mesh;
  return {build_mesh({unflattened(built.aligned.model.mean()), landmarks.triangles}),
          {built.registration.frame.reference.shape_map.map.lattice, VertexMap<Vec2>(landmarks.turns),
           landmarks.jumps},
          curvatures_at(built.registration.frame.group.surface, landmarks.turns)};
}

}  // namespace foramen
