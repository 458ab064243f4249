#include "workflow/run_build.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <memory>
#include <set>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/stages/refit.hpp"
#include "foramen/store/folder_store.hpp"
#include "inputs/subject_of.hpp"
#include "io/atomic_file.hpp"
#include "modelfiles/corresponding_folder.hpp"
#include "modelfiles/describe_run.hpp"
#include "modelfiles/error_maps_file.hpp"
#include "modelfiles/folder_lock.hpp"
#include "modelfiles/metrics_file.hpp"
#include "modelfiles/model_folder.hpp"
#include "modelfiles/version.hpp"
#include "pages/model_page.hpp"
#include "workflow/build_from.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

// Finds out before the work that the results can be written after it.
void prepare_folder(const fs::path& folder) {
  make_folder(folder);
  const fs::path probe = folder / ".foramen-write-test";
  if (!std::ofstream(probe))
    throw IoError(folder.string() + ": the folder cannot be written to; give another",
                  {{RemedyKind::another_output}});
  std::error_code ignored;
  fs::remove(probe, ignored);
}

// What killed builds left half-written under names of their own.
void remove_leftovers_of_builds(const fs::path& model) {
  for (const fs::path& folder : {model, model / "corresponding", model / "modes"}) remove_leftovers(folder);
}

// Finished stages are kept in the folder that was asked for, or in the model's own until all is written.
std::shared_ptr<FolderStore> store_of(const BuildRequest& request) {
  if (!request.store.empty())
    return std::make_shared<FolderStore>(request.store, program_identity(), FolderStore::Use::shared);
  const fs::path folder = request.output / ".resume";
  std::error_code failed;
  if (!request.resume) fs::remove_all(folder, failed);
  return std::make_shared<FolderStore>(folder, program_identity(), FolderStore::Use::alone);
}

// A former build into the same folder may have had other shapes: their files would pass for this model's.
void remove_stale(const fs::path& folder, const std::set<std::string>& expected) {
  if (!fs::is_directory(folder)) return;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".ply" && !expected.contains(entry.path().filename().string()))
      fs::remove(entry.path());
}

void remove_stale_files(const fs::path& folder, const std::vector<InputShape>& inputs) {
  std::set<std::string> corresponding;
  for (const InputShape& input : inputs) corresponding.insert(input.stem + ".ply");
  remove_stale(folder / "corresponding", corresponding);
  remove_stale(folder / "modes", {});
}

// By the pattern, else the folders that tell the files apart. Empty: the subjects are not known.
std::vector<std::string> subjects_of(const std::vector<InputShape>& inputs, const std::string& pattern) {
  std::vector<std::string> subjects;
  for (const InputShape& input : inputs) {
    if (pattern.empty() && input.folder.empty()) return {};
    subjects.push_back(pattern.empty() ? input.folder : subject_of(input.stem, pattern));
  }
  return subjects;
}

std::vector<NamedErrorMap> error_maps_of(const Evaluation& evaluation) {
  std::vector<NamedErrorMap> maps;
  for (std::size_t i = 0; i < evaluation.names.size(); ++i)
    maps.push_back({evaluation.names[i], evaluation.representation.shapes[i].map});
  return maps;
}

// Adds what evaluate() cannot measure, since it takes whole builds.
void add_refits(Evaluation& evaluation, std::span<const Shape> shapes, const BuildOptions& options,
                const RunContext& ctx) {
  const auto start = std::chrono::steady_clock::now();
  GeneralizationOptions measure{.scale = options.model.scale,
                                .weights = options.model.weights,
                                .samples = evaluation.options.samples,
                                .seed = options.landmarks.seed};
  evaluation.refit = refit_generalization(shapes, {}, options, measure, ctx);
  if (!evaluation.subjects.empty()) {
    measure.leave_out = LeaveOut::subject;
    evaluation.refit_by_subject = refit_generalization(shapes, evaluation.subjects, options, measure, ctx);
  }
  evaluation.seconds.refit = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void add_refit_notes(std::vector<Message>& notes, const std::optional<RefitGeneralization>& refit) {
  if (!refit) return;
  for (const RefitGeneralization::Failure& failure : refit->failures)
    notes.push_back("refit without " + failure.without + ": " + failure.shape + ": " + failure.reason);
}

std::vector<Message> notes_on(const BuildRecord& record, const Evaluation& evaluation) {
  std::vector<Message> notes = record.notes;
  for (const InputShape& input : record.inputs) {
    if (input.was_inward) notes.push_back(source_of(input) + ": triangles were wound inward; reversed");
    if (input.repair) notes.push_back(source_of(input) + ": repaired: " + summary(*input.repair));
  }
  const Landmarks& landmarks = record.built.landmarks;
  if (landmarks.remaining_flips > 0)
    notes.push_back(
        {std::to_string(landmarks.remaining_flips) +
             " landmark triangles are flipped or degenerate on some shape and could not be mended "
             "within the budget of landmarks: give more",
         {{RemedyKind::more_landmarks}}});
  if (landmarks.remaining_self_intersections > 0)
    notes.push_back(
        {std::to_string(landmarks.remaining_self_intersections) +
             " pairs of landmark triangles meet on some shape whose surface does not meet itself, and "
             "could not be parted within the budget of landmarks: give more",
         {{RemedyKind::more_landmarks}}});
  add_refit_notes(notes, evaluation.refit);
  add_refit_notes(notes, evaluation.refit_by_subject);
  return notes;
}

}  // namespace

BuildSummary run_build(const BuildRequest& request, const RunContext& ctx) {
  const auto start = std::chrono::steady_clock::now();
  if (!request.subject_pattern.empty()) subject_of("", request.subject_pattern);
  const auto [files, search_notes] = find_shape_files(request.inputs);
  if (request.labels &&
      std::none_of(files.begin(), files.end(), [](const ShapeFile& file) { return is_label_map(file.path); }))
    throw InvalidInput("there is no label map among the inputs: leave out the options for label maps");
  prepare_folder(request.output);
  const FolderLock lock(request.output);
  remove_leftovers_of_builds(request.output);
  const auto store = store_of(request);
  ctx.step("read", 0);
  Cohort read =
      read_cohort(files, request.unit, ctx, request.labels.value_or(LabelRequest{}), request.repair);
  read.notes.insert(read.notes.begin(), search_notes.begin(), search_notes.end());
  const RunContext keeping = ctx.with_store(store);
  const BuildRecord record = build_from(std::move(read), request.build, keeping);

  const std::vector<Shape> shapes = surfaces_of(record.inputs);
  const CorrespondingCohort cohort = corresponding_cohort(
      shapes, record.built.landmarks, subjects_of(record.inputs, request.subject_pattern));
  EvaluationOptions evaluation_options = request.evaluation;
  evaluation_options.scale = request.build.model.scale;
  evaluation_options.weights = request.build.model.weights;
  evaluation_options.seed = request.build.landmarks.seed;
  std::optional<TrueCorrespondence> truth;
  if (!request.truth.empty()) truth = read_truth(request.truth, cohort.names, request.unit);
  Evaluation evaluation = evaluate(cohort, evaluation_options, keeping, truth ? &*truth : nullptr);
  if (request.refit) add_refits(evaluation, shapes, request.build, keeping);

  ctx.step("write", 0);
  remove_stale_files(request.output, record.inputs);
  write_model_files(request.output, record, request.canonical_command, millimetres_per(request.unit.length));
  write_metrics(request.output, evaluation);
  write_error_maps(request.output / "error_maps.h5", error_maps_of(evaluation));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const RunDescription asked{request.canonical_command, request.build,
                             request.labels.value_or(LabelRequest{})};
  RunRecord run = describe_run(asked, record, evaluation, {seconds, ctx.threads(), store->taken_up()});
  BuildSummary summary;
  summary.json = run_json(run);
  write_file(request.output / "run.json", summary.json + "\n");
  const ModelRecord written = record_as_written(std::move(run), std::move(evaluation), record);
  const ModelPage page = model_page(written);
  write_file(request.output / "report.html", page.html);
  if (request.store.empty()) store->remove();
  ctx.step("write", 1);

  summary.left_out = record.left_out;
  summary.notes = notes_on(record, written.evaluation);
  for (const std::string& note : store->notes()) summary.notes.emplace_back(note);
  summary.text = model_summary(written.run, written.evaluation) + "\nreport.html: " + page.remark;
  return summary;
}

}  // namespace foramen
