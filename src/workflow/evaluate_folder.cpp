#include "workflow/evaluate_folder.hpp"

#include <algorithm>
#include <utility>

#include "findings/mark_findings.hpp"
#include "findings/model_report.hpp"
#include "foramen/core/error.hpp"
#include "foramen/io/label_map.hpp"
#include "foramen/io/mesh_file.hpp"
#include "inputs/read_cohort.hpp"
#include "inputs/read_marks.hpp"
#include "inputs/subject_of.hpp"
#include "inputs/surface_size.hpp"
#include "io/atomic_file.hpp"
#include "modelfiles/corresponding_folder.hpp"
#include "modelfiles/metrics_file.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

struct Surfaces {
  std::vector<Mesh> meshes;
  std::vector<AnatomicalSpace> spaces;  // LPS if a file has no tag
};

Surfaces original_surfaces(const fs::path& folder, const std::vector<std::string>& names,
                           const InputUnit& unit, std::vector<Message>& notes) {
  if (is_label_map(folder))
    throw InvalidInput(folder.string() + ": is a label map: make meshes of its labels first",
                       {{RemedyKind::extract_surfaces}});
  const auto [files, search_notes] = find_meshes({folder});
  notes.insert(notes.end(), search_notes.begin(), search_notes.end());
  Surfaces surfaces;
  SizeCheck sizes(unit);
  for (const std::string& name : names) {
    const ShapeFile* file = file_named(files, name);
    if (file == nullptr)
      throw InvalidInput(folder.string() + ": there is no original surface for the shape " + name +
                         "; its file must have this name");
    auto [soup, space, file_notes] = read_mesh(file->path);
    for (const Message& note : file_notes) notes.push_back(note.about(file->shown()));
    for (Vec3& p : soup.points) p *= millimetres_per(unit.length);
    sizes.add(file->path.string(), soup.points);
    surfaces.meshes.push_back(build_mesh(std::move(soup)));
    surfaces.spaces.push_back(space.value_or(AnatomicalSpace::lps));
  }
  if (const auto note = sizes.note()) notes.push_back(*note);
  return surfaces;
}

// By the pattern, else as the model's metrics say, else the folders that tell the files apart. Empty: the
// subjects are not known.
std::vector<std::string> subjects_of(const EvaluateFolderRequest& request, const CorrespondingFolder& read) {
  std::vector<std::string> subjects;
  if (!request.subject_pattern.empty()) {
    for (const std::string& name : read.names) subjects.push_back(subject_of(name, request.subject_pattern));
    return subjects;
  }
  if (!fs::exists(request.corresponding / "metrics.json")) return read.folders;
  const Evaluation of_model = read_metrics(request.corresponding);
  if (of_model.subjects.empty()) return read.folders;
  for (const std::string& name : read.names) {
    const auto found = std::find(of_model.names.begin(), of_model.names.end(), name);
    if (found == of_model.names.end()) return read.folders;
    subjects.push_back(of_model.subjects[found - of_model.names.begin()]);
  }
  return subjects;
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

// Notes on marks that may have been made in other coordinates, or from the other end of a curve.
void note_doubtful(const MarkTransfer& marks, const std::vector<std::string>& names,
                   std::vector<Message>& notes) {
  constexpr double far_mm = 5;
  for (std::size_t s = 0; s < names.size(); ++s)
    if (marks.off_surface_mm[s] > far_mm)
      notes.emplace_back("the marks of " + names[s] + " lie " + fixed(marks.off_surface_mm[s], 1) +
                         " mm off its surface on average: check their axes (LPS or RAS) and their unit");
  for (const ReversedCurve& curve : marks.reversed)
    notes.emplace_back("the curve '" + curve.mark + "' of " + names[curve.shape] +
                       " runs from the other end than on most shapes: its ends were compared as marked");
}

struct MarkMeasures {
  std::optional<MarkTransfer> marks;
  std::optional<RegionTransfer> regions;
};

MarkMeasures measure_marks(const EvaluateFolderRequest& request, const CorrespondingCohort& cohort,
                           const MarkedShapes& shapes, std::vector<Message>& notes, const RunContext& ctx) {
  MarkMeasures measures;
  if (!request.marks.empty()) {
    const ReadMarks read = read_marks(request.marks, shapes, request.unit);
    notes.insert(notes.end(), read.notes.begin(), read.notes.end());
    measures.marks = mark_transfer(cohort, read.marks, ctx);
    note_doubtful(*measures.marks, cohort.names, notes);
  }
  if (!request.regions.empty()) {
    const ReadRegions read = read_regions(request.regions, shapes);
    notes.insert(notes.end(), read.notes.begin(), read.notes.end());
    measures.regions = region_transfer(cohort, read.regions, ctx);
  }
  return measures;
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
  for (const std::string& line : mark_lines(e)) text += line + "\n";
  const std::vector<NamedEvaluation> named{{"mm", &e}};
  std::vector<ReportTable> tables = mark_tables(named);
  for (ReportTable& table : model_tables(named)) tables.push_back(std::move(table));
  for (const ReportTable& table : tables) {
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
  cohort.subjects = subjects_of(request, folder);
  std::vector<Message> notes = folder.notes;
  MarkedShapes marked{folder.names, folder.spaces, {}};
  if (!request.shapes.empty()) {
    Surfaces surfaces = original_surfaces(request.shapes, folder.names, request.unit, notes);
    cohort.inputs = std::move(surfaces.meshes);
    marked.spaces = std::move(surfaces.spaces);
  } else {
    for (const auto& points : folder.shapes) cohort.inputs.push_back(build_mesh({points, folder.triangles}));
  }
  marked.surfaces = cohort.inputs;
  std::optional<TrueCorrespondence> truth;
  if (!request.truth.empty()) truth = read_truth(request.truth, folder.names, request.unit);
  if (!request.true_landmarks.empty()) {
    if (!truth)
      throw InvalidInput("true landmarks need the true correspondence: give it", {{RemedyKind::give_truth}});
    write_true_landmarks(request.true_landmarks, cohort, *truth, request.unit, ctx);
  }

  // Before the other measures, which take longer, so that a wrong file of marks is named soon.
  MarkMeasures of_marks = measure_marks(request, cohort, marked, notes, ctx);
  EvaluatedFolder result{
      evaluate(cohort, request.options, ctx, truth ? &*truth : nullptr), {}, {}, std::move(notes)};
  result.evaluation.marks = std::move(of_marks.marks);
  result.evaluation.regions = std::move(of_marks.regions);
  if (!request.output.empty()) {
    make_folder(request.output);
    write_metrics(request.output, result.evaluation);
  }
  result.text = summary(result.evaluation);
  result.json = metrics_json(result.evaluation);
  return result;
}

}  // namespace foramen
