#include "workflow/surface_projector.hpp"

#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

namespace foramen {
namespace {

using nlohmann::ordered_json;

std::vector<double> distances_to(const TriangleTree& surface, std::span<const Vec3> points) {
  std::vector<double> distances;
  distances.reserve(points.size());
  for (const Vec3& p : points) distances.push_back(std::sqrt(surface.closest(p).squared_distance));
  return distances;
}

ordered_json distance_json(const SurfaceDistance& d) {
  return {{"mean_mm", d.mean}, {"p95_mm", d.p95}, {"hausdorff_mm", d.hausdorff}};
}

}  // namespace

SurfaceProjector::SurfaceProjector(UsableModel model, const RunContext& ctx)
    : model_(std::move(model)), registrar_(registrar_of(model_, ctx)) {}

AlignedModel SurfaceProjector::without(std::span<const std::string> left_out) const {
  return model_without(model_.aligned, model_.names, left_out, model_.scale);
}

Projection SurfaceProjector::operator()(const Mesh& surface, std::span<const std::string> left_out,
                                        const RunContext& ctx) const {
  std::optional<AlignedModel> others;
  if (!left_out.empty()) others = without(left_out);
  Projection result;
  result.landmarks = registrar_.landmarks_on(surface, ctx);
  result.shape = project_shape(result.landmarks, model_.aligned, model_.scale);
  const TriangleTree tree(surface);
  const auto mesh_tree = [&](const std::vector<Vec3>& points) {
    return TriangleTree(build_mesh({points, model_.landmarks.triangles}));
  };
  const TriangleTree fit = mesh_tree(result.shape.fit);
  result.representation = surface_distance(tree, mesh_tree(result.landmarks));
  result.fit = surface_distance(tree, fit);
  result.residual = distances_to(fit, surface.positions());
  result.fit_residual = distances_to(tree, result.shape.fit);
  if (others) {
    result.left_out.assign(left_out.begin(), left_out.end());
    result.fit_without_left_out =
        surface_distance(tree, mesh_tree(project_shape(result.landmarks, *others, model_.scale).fit));
  }
  return result;
}

ordered_json projection_json(const Projection& p) {
  ordered_json json{{"scores_sd", std::vector<double>(p.shape.scores.begin(), p.shape.scores.end())},
                    {"representation", distance_json(p.representation)},
                    {"fit", distance_json(p.fit)}};
  json["fit"]["landmark_rms_mm"] = p.shape.landmark_rms;
  if (p.fit_without_left_out) {
    json["left_out"] = p.left_out;
    json["fit_without_left_out"] = distance_json(*p.fit_without_left_out);
  }
  return json;
}

}  // namespace foramen
