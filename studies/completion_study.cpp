// Measures how well a model completes vertebrae that are not in the model and whose posterior elements are
// removed. Prints a Markdown row per shape and method. studies/completion.sh makes the models and runs this
// program.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "apply/part_surface.hpp"
#include "foramen/apply/complete_surface.hpp"
#include "foramen/apply/project_shape.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/io/mesh_file.hpp"
#include "foramen/spatial/surface_distance.hpp"
#include "foramen/topology/handle_loops.hpp"
#include "inputs/read_cohort.hpp"
#include "modelfiles/usable_model.hpp"

namespace {

namespace fs = std::filesystem;
using namespace foramen;

constexpr int samples = 20000;

struct Study {
  std::string model, keep;
  std::vector<std::string> shapes;
  std::vector<double> beyond{0, 0.3};
  double noise = 0.5;
  bool whole = false, leave_out = false;
};

// The centre of the canal: the middle of the shortest loop round it.
Vec3 canal_centre(const Mesh& mesh) {
  const RunContext ctx;
  const EdgeMap<double> lengths = edge_lengths(mesh);
  EdgeLoop loop = shortest_loop(mesh, lengths, ctx);
  if (loop_kind(mesh, loop) != LoopKind::tunnel) loop = shortest_crossing_loop(mesh, loop, lengths);
  Vec3 sum = Vec3::Zero();
  for (HalfedgeId h : loop) sum += mesh.position(mesh.from(h));
  return sum / static_cast<double>(loop.size());
}

// A surface without the triangles that have a corner behind the centre of the canal (larger y, which is
// posterior in LPS).
struct CutShape {
  double limit_y = 0;
  Mesh whole, kept, removed;
};

CutShape cut(const Mesh& mesh) {
  CutShape shape;
  shape.whole = mesh;
  shape.limit_y = canal_centre(mesh).y();
  TriangleSoup kept = mesh.soup(), removed = kept;
  kept.triangles.clear();
  removed.triangles.clear();
  for (FaceId f : mesh.faces()) {
    bool behind = false;
    for (const Vec3& p : mesh.triangle(f)) behind = behind || p.y() > shape.limit_y;
    (behind ? removed : kept).triangles.push_back(mesh.triangles()[f.index]);
  }
  shape.kept = part_surface(kept);
  shape.removed = part_surface(removed);
  return shape;
}

std::vector<double> distances(const Mesh& from, const TriangleTree& to,
                              const std::function<bool(const Vec3&)>& counts) {
  std::vector<double> all;
  for (const SurfacePoint& p : sample_surface(from, samples, Rng(1)))
    if (const Vec3 at = position(from, p); counts(at))
      all.push_back(std::sqrt(to.closest(at).squared_distance));
  return all;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

// Errors in the removed part: the mean distance from the true surface to the candidate, the mean distance
// from the candidate (behind the cut) to the true surface, their average, and p95 and maximum of both sets of
// distances.
struct Error {
  double there = 0, back = 0, mean = 0, p95 = 0, largest = 0;
};

Error error_of(const Mesh& candidate, const CutShape& shape, bool both_ways) {
  std::vector<double> there =
      distances(shape.removed, TriangleTree(candidate), [](const Vec3&) { return true; });
  std::vector<double> back;
  if (both_ways)
    back =
        distances(candidate, TriangleTree(shape.whole), [&](const Vec3& p) { return p.y() > shape.limit_y; });
  Error error{::mean(there), ::mean(back), 0, 0, 0};
  error.mean = both_ways ? 0.5 * (error.there + error.back) : error.there;
  there.insert(there.end(), back.begin(), back.end());
  std::sort(there.begin(), there.end());
  error.p95 = there[there.size() * 95 / 100];
  error.largest = there.back();
  return error;
}

void row(const std::string& name, const std::string& method, const Error& e, const std::string& more = {}) {
  std::printf("| %s | %s | %.2f | %.2f | %.2f | %.2f | %.2f | %s |\n", name.c_str(), method.c_str(), e.mean,
              e.there, e.back, e.p95, e.largest, more.c_str());
  std::fflush(stdout);
}

// For the completed landmarks behind the cut: the mean standard deviation, and the share whose distance to
// the true surface is within two standard deviations.
std::string calibration(const CompletedSurface& completed, const CutShape& shape) {
  const TriangleTree truth(shape.whole);
  const std::vector<double> deviations = standard_deviations(completed.shape);
  const std::vector<Vec3> points = unflattened(completed.shape.mean);
  int behind = 0, within = 0;
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].y() <= shape.limit_y) continue;
    ++behind;
    sum += deviations[i];
    if (std::sqrt(truth.closest(points[i]).squared_distance) <= 2 * deviations[i]) ++within;
  }
  char text[80];
  std::snprintf(text, sizeof text, "sd %.2f, %.0f %% within 2 sd", sum / behind, 100.0 * within / behind);
  return text;
}

void keep(const Study& study, const std::string& name, const TriangleSoup& soup) {
  if (study.keep.empty()) return;
  fs::create_directories(study.keep);
  write_ply(fs::path(study.keep) / (name + ".ply"), soup);
}

std::string subject_of(const std::string& name) { return name.substr(0, name.find('_')); }

// The model without the shapes of a subject. The correspondence was computed with these shapes.
AlignedModel without_subject(const UsableModel& model, const std::string& subject) {
  std::vector<std::string> left_out;
  for (const std::string& name : model.names)
    if (subject_of(name) == subject) left_out.push_back(name);
  return model_without(model.aligned, model.names, left_out, model.scale);
}

void study_shape(const Study& study, UsableModel model, const fs::path& file) {
  const RunContext ctx;
  const std::string name = file.stem().string();
  if (study.leave_out) model.aligned = without_subject(model, subject_of(name));
  const CutShape shape = cut(read_shape(file, LengthUnit::millimetre).mesh);
  const auto& triangles = model.landmarks.triangles;
  const Mesh mean_mesh = build_mesh({model.aligned.alignment.mean, triangles});
  keep(study, name + "_kept", shape.kept.soup());
  keep(study, name + "_removed", shape.removed.soup());

  row(name, "nothing done", error_of(shape.kept, shape, false));
  const RigidTransform to_model = align_part(shape.kept, mean_mesh, ctx).front().transform;
  row(name, "mean, aligned", error_of(transformed(mean_mesh, to_model.inverse()), shape, true));
  for (const double beyond : study.beyond) {
    CompleteSurfaceOptions options;
    options.scale = model.scale;
    options.noise_mm = study.noise;
    options.beyond_modes = beyond;
    const CompletedSurface completed = complete_surface(shape.kept, model.aligned.model, ctx, options);
    const TriangleSoup soup{unflattened(completed.shape.mean), triangles};
    char method[80];
    std::snprintf(method, sizeof method, "completed, beyond modes %g, noise %g mm", beyond, study.noise);
    row(name, method, error_of(build_mesh(soup), shape, true), calibration(completed, shape));
    std::snprintf(method, sizeof method, "_completed_%g", beyond);
    keep(study, name + method, soup);
    if (!study.whole) continue;
    const CompletedSurface fitted = complete_surface(shape.whole, model.aligned.model, ctx, options);
    std::snprintf(method, sizeof method, "fitted to the whole, beyond modes %g", beyond);
    row(name, method, error_of(build_mesh({unflattened(fitted.shape.mean), triangles}), shape, true));
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program{"Completion of vertebrae without their posterior elements, measured"};
  Study study;
  program.add_option("model", study.model, "folder of a model that has not seen the shapes")->required();
  program.add_option("shapes", study.shapes, "their surfaces, in LPS")->required();
  program.add_option("--beyond-modes", study.beyond, "see foramen complete; one or more");
  program.add_option("--noise", study.noise, "see foramen complete");
  program.add_flag("--whole", study.whole, "also fitted to the whole surface: what the model can do at best");
  program.add_flag(
      "--leave-out", study.leave_out,
      "the model has seen the shapes: its alignment and PCA are redone without those of the subject");
  program.add_option("--keep", study.keep, "folder for the meshes");
  CLI11_PARSE(program, argc, argv);
  try {
    const UsableModel model = read_usable_model(study.model);
    for (const std::string& file : study.shapes) study_shape(study, model, file);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "completion_study: %s\n", e.what());
    return 1;
  }
  return 0;
}
