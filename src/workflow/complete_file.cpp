#include "workflow/complete_file.hpp"

#include <cstdio>

#include <nlohmann/json.hpp>

#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "foramen/io/statismo_file.hpp"
#include "io/atomic_file.hpp"
#include "modelfiles/usable_model.hpp"
#include "workflow/completion.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct Part {
  Mesh mesh;  // mm
  AnatomicalSpace space = AnatomicalSpace::lps;
};

Part read_part(const fs::path& file, LengthUnit unit) {
  MeshFile read = read_mesh(file);
  for (Vec3& p : read.soup.points) p *= millimetres_per(unit);
  try {
    return {usable_part(read.soup), read.space.value_or(AnatomicalSpace::lps)};
  } catch (const TopologyError& e) {
    throw TopologyError(message_of(e).about(file.string()));
  } catch (const InvalidInput& e) {
    throw InvalidInput(message_of(e).about(file.string()));
  }
}

void write_posterior(const fs::path& path, const ShapeDistribution& shape, const UsableModel& model) {
  const ShapeModel modes = principal_model(shape, model.landmarks.triangles);
  StatismoModel file;
  file.points = unflattened(modes.mean());
  file.triangles = modes.triangles();
  file.mean = modes.mean();
  file.basis = modes.basis();
  file.variance = modes.variance();
  file.build_time = build_time();
  file.parameters = {{"command", "foramen complete"}};
  write_statismo(path, file);
}

void write_completed(const fs::path& path, const CompletedSurface& completed, const UsableModel& model,
                     AnatomicalSpace space, LengthUnit unit) {
  const std::vector<VertexScalar> scalars{
      {"standard_deviation_mm", standard_deviations(completed.shape)},
      {"seen", std::vector<double>(completed.seen.begin(), completed.seen.end())}};
  TriangleSoup soup{unflattened(completed.shape.mean), model.landmarks.triangles};
  for (Vec3& p : soup.points) p /= millimetres_per(unit);
  write_ply(path, soup, space, scalars);
}

std::string completed_text(const ordered_json& json) {
  const auto number = [&](const char* key) { return json.at(key).get<double>(); };
  char text[200];
  std::snprintf(text, sizeof text,
                "mean distance to the part %.2f mm; %.0f %% of the landmarks seen; standard deviation %.2f "
                "mm where seen, %.2f mm elsewhere",
                number("distance_mm"), 100 * number("seen_share"), number("standard_deviation_seen_mm"),
                number("standard_deviation_unseen_mm"));
  return text;
}

}  // namespace

CompleteSummary complete_file(const CompleteRequest& request, const RunContext& ctx) {
  const UsableModel model = read_usable_model(request.model);
  const Part part = read_part(request.surface, request.unit);
  CompleteSurfaceOptions options = request.options;
  options.scale = model.scale;
  ctx.step("complete", 0);
  const CompletedSurface completed = complete_surface(part.mesh, model.aligned.model, ctx, options);
  ctx.step("complete", 1);

  const fs::path file = request.output / "completed.ply";
  fs::create_directories(request.output);
  write_completed(file, completed, model, part.space, request.unit);
  write_posterior(request.output / "posterior.h5", completed.shape, model);
  ordered_json json{{"surface", request.surface.filename().string()}};
  json.update(completion_json(completed));
  CompleteSummary summary{file.string() + ": " + completed_text(json), json.dump(2),
                          completion_note(completed)};
  if (summary.note) *summary.note += ": look at " + file.string();
  write_file(request.output / "complete.json", summary.json + "\n");
  return summary;
}

}  // namespace foramen
