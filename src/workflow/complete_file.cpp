#include "workflow/complete_file.hpp"

#include <cstdio>
#include <utility>

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

struct PartFile {
  PartOfVertebra part;
  AnatomicalSpace space = AnatomicalSpace::lps;
  std::vector<Message> notes;  // on how the file was read, and on its size
};

PartFile read_part(const CompleteRequest& request, const UsableModel& model) {
  const fs::path& file = request.surface;
  MeshFile read = read_mesh(file);
  try {
    PartFile file_of_part{usable_part(std::move(read.soup), request.unit, model.aligned.model),
                          read.space.value_or(AnatomicalSpace::lps),
                          {}};
    for (const Message& note : read.notes) file_of_part.notes.push_back(note.about(file.string()));
    if (const auto& note = file_of_part.part.size_note)
      file_of_part.notes.push_back(note->about(file.string()));
    return file_of_part;
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
                     AnatomicalSpace space, const InputUnit& unit) {
  const std::vector<VertexScalar> scalars{
      {"standard_deviation_mm", standard_deviations(completed.shape)},
      {"seen", std::vector<double>(completed.seen.begin(), completed.seen.end())}};
  TriangleSoup soup{unflattened(completed.shape.mean), model.landmarks.triangles};
  for (Vec3& p : soup.points) p /= millimetres_per(unit.length);
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
  const PartFile read = read_part(request, model);
  CompleteSurfaceOptions options = request.options;
  options.scale = model.scale;
  ctx.step("complete", 0);
  const CompletedSurface completed = complete_surface(read.part.mesh, model.aligned.model, ctx, options);
  ctx.step("complete", 1);

  const fs::path file = request.output / "completed.ply";
  make_folder(request.output);
  write_completed(file, completed, model, read.space, request.unit);
  write_posterior(request.output / "posterior.h5", completed.shape, model);
  ordered_json json{{"surface", request.surface.filename().string()}};
  json.update(completion_json(completed));
  CompleteSummary summary{file.string() + ": " + completed_text(json), json.dump(2), read.notes};
  if (const auto note = completion_note(completed))
    summary.notes.emplace_back(*note + ": look at " + file.string());
  write_file(request.output / "complete.json", summary.json + "\n");
  return summary;
}

}  // namespace foramen
