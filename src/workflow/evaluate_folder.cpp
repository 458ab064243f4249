#include "workflow/evaluate_folder.hpp"

#include <utility>

#include "findings/model_report.hpp"
#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "inputs/read_cohort.hpp"
#include "inputs/subject_of.hpp"
#include "inputs/surface_size.hpp"
#include "io/atomic_file.hpp"
#include "modelfiles/corresponding_folder.hpp"
#include "modelfiles/metrics_file.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

std::vector<Mesh> original_surfaces(const fs::path& folder, const std::vector<std::string>& names,
                                    const InputUnit& unit) {
  const auto files = find_meshes({folder}).files;
  std::vector<Mesh> surfaces;
  SizeCheck sizes(unit);
  for (const std::string& name : names) {
    const ShapeFile* file = file_named(files, name);
    if (file == nullptr)
      throw InvalidInput(folder.string() + ": there is no original surface for the shape " + name +
                         "; its file must have this name");
    TriangleSoup soup = read_mesh(file->path).soup;
    for (Vec3& p : soup.points) p *= millimetres_per(unit.length);
    sizes.add(file->path.string(), soup.points);
    surfaces.push_back(build_mesh(std::move(soup)));
  }
  return surfaces;
}

void write_true_landmarks(const fs::path& target, const CorrespondingCohort& cohort,
                          const TrueCorrespondence& truth, const InputUnit& unit, const RunContext& ctx) {
  auto landmarks = true_landmarks(cohort, truth, ctx);
  make_folder(target);
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    for (Vec3& p : landmarks[i]) p /= millimetres_per(unit.length);
    write_ply(target / (cohort.names[i] + ".ply"), {landmarks[i], cohort.triangles});
  }
}

std::string summary(const Evaluation& e) {
  std::string text = std::to_string(e.names.size()) + " shapes, " + std::to_string(e.landmarks) +
                     " landmarks (weights: " + std::string(word_of(e.options.weights)) + ")\n";
  const Representation& r = e.representation;
  text += "representation error: mean " + fixed(r.mean_surface, 3) + ", p95 " + fixed(r.p95, 3) +
          ", Hausdorff " + fixed(r.hausdorff, 2) + " mm\nflipped triangles a shape: plain " +
          fixed(r.plain_flips, 1) + ", confirmed " + fixed(r.confirmed_flips, 1) +
          "\nself-intersecting pairs of triangles a shape: " + fixed(r.self_intersections, 1) +
          ", of the inputs " + fixed(r.input_self_intersections, 1) + "\n" + drawn_shapes_line(e.drawn) +
          "\n";
  if (e.truth)
    text += "truth error: mean " + fixed(e.truth->error.mean, 3) + ", p95 " + fixed(e.truth->error.p95, 3) +
            ", max " + fixed(e.truth->error.max, 2) + " mm\n";
  for (const ReportTable& table : model_tables({{"mm", &e}})) {
    text += "\n" + table.title + "\n";
    for (const auto& row : table.rows) text += "  " + row[0] + "\t" + row[1] + "\n";
  }
  return text;
}

}  // namespace

EvaluatedFolder evaluate_folder(const EvaluateFolderRequest& request, const RunContext& ctx) {
  const fs::path inner = request.corresponding / "corresponding";
  const CorrespondingFolder folder =
      read_corresponding(fs::is_directory(inner) ? inner : request.corresponding, request.unit);
  CorrespondingCohort cohort{folder.names, {}, folder.triangles, folder.shapes, {}};
  if (!request.subject_pattern.empty())
    for (const std::string& name : folder.names)
      cohort.subjects.push_back(subject_of(name, request.subject_pattern));
  if (!request.shapes.empty())
    cohort.inputs = original_surfaces(request.shapes, folder.names, request.unit);
  else
    for (const auto& points : folder.shapes) cohort.inputs.push_back(build_mesh({points, folder.triangles}));
  std::optional<TrueCorrespondence> truth;
  if (!request.truth.empty()) truth = read_truth(request.truth, folder.names, request.unit);
  if (!request.true_landmarks.empty()) {
    if (!truth)
      throw InvalidInput("true landmarks need the true correspondence: give it", {{RemedyKind::give_truth}});
    write_true_landmarks(request.true_landmarks, cohort, *truth, request.unit, ctx);
  }

  EvaluatedFolder result{evaluate(cohort, request.options, ctx, truth ? &*truth : nullptr), {}, {}};
  if (!request.output.empty()) {
    make_folder(request.output);
    write_metrics(request.output, result.evaluation);
  }
  if (folder.size_note) result.notes.push_back(*folder.size_note);
  result.text = summary(result.evaluation);
  result.json = metrics_json(result.evaluation);
  return result;
}

}  // namespace foramen
