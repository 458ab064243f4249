#include <algorithm>
#include <tuple>
#include <utility>

#include <pybind11/stl.h>
#include <nlohmann/json.hpp>

#include "bindings.hpp"
#include "foramen/core/error.hpp"
#include "foramen/evaluate/evaluate.hpp"
#include "inputs/subject_of.hpp"
#include "modelfiles/marks_json.hpp"
#include "options.hpp"

namespace foramen::python {
namespace {

// A column of numbers, one per item.
template <class Number = double, class Items, class Value>
py::array_t<Number> column(const Items& items, const Value& value) {
  py::array_t<Number> out(static_cast<py::ssize_t>(items.size()));
  Number* next = out.mutable_data();
  for (const auto& item : items) *next++ = static_cast<Number>(value(item));
  return out;
}

// The means and standard errors at all numbers of modes.
template <class Items, class Value>
py::dict estimates(const Items& items, const Value& estimate_of) {
  py::dict out;
  out["mean"] = column(items, [&](const auto& item) { return estimate_of(item).mean; });
  out["standard_error"] = column(items, [&](const auto& item) { return estimate_of(item).standard_error; });
  return out;
}

// The means and standard errors, with the values (modes, items) of all shapes or draws.
py::dict errors(const std::vector<ErrorsAtModes>& all, Estimate ErrorsAtModes::*estimate,
                double ShapeError::*error) {
  py::dict out = estimates(all, [&](const ErrorsAtModes& at) { return at.*estimate; });
  const std::size_t items = all.empty() ? 0 : all.front().items.size();
  py::array_t<double> values({static_cast<py::ssize_t>(all.size()), static_cast<py::ssize_t>(items)});
  double* next = values.mutable_data();
  for (const ErrorsAtModes& at : all)
    for (const ShapeError& item : at.items) *next++ = item.*error;
  out["values"] = values;
  return out;
}

py::dict model_errors(const std::vector<ErrorsAtModes>& all) {
  py::dict out;
  out["modes"] = column<int>(all, [](const ErrorsAtModes& at) { return at.modes; });
  out["hausdorff"] = errors(all, &ErrorsAtModes::hausdorff, &ShapeError::hausdorff);
  out["mean_surface"] = errors(all, &ErrorsAtModes::mean_surface, &ShapeError::mean_surface);
  out["landmark_rms"] = errors(all, &ErrorsAtModes::landmark_rms, &ShapeError::landmark_rms);
  return out;
}

py::dict compactness_of(const std::vector<CompactnessAtModes>& all) {
  py::dict out;
  out["modes"] = column<int>(all, [](const auto& at) { return at.modes; });
  out["variance_per_landmark"] = column(all, [](const auto& at) { return at.variance_per_landmark; });
  out["fraction"] = column(all, [](const auto& at) { return at.fraction; });
  return out;
}

py::dict ensemble_of(const std::vector<EnsembleAtModes>& all) {
  py::dict out;
  out["modes"] = column<int>(all, [](const auto& at) { return at.modes; });
  out["generalization"] = estimates(all, [](const auto& at) { return at.generalization; });
  out["specificity"] = estimates(all, [](const auto& at) { return at.specificity; });
  return out;
}

py::dict drawn_of(const DrawnShapes& drawn) {
  py::dict out;
  out["self_intersections"] = column<int>(drawn.draws, [](const auto& d) { return d.self_intersections; });
  out["folded"] = column<int>(drawn.draws, [](const auto& d) { return d.folded; });
  out["opposing_mean"] = column<int>(drawn.draws, [](const auto& d) { return d.opposing_mean; });
  return out;
}

py::dict representation_of(const std::vector<ShapeRepresentation>& shapes) {
  py::dict out;
  out["mean"] = column(shapes, [](const auto& s) { return s.distance.mean; });
  out["p95"] = column(shapes, [](const auto& s) { return s.distance.p95; });
  out["hausdorff"] = column(shapes, [](const auto& s) { return s.distance.hausdorff; });
  out["plain_flips"] = column<int>(shapes, [](const auto& s) { return s.plain_flips; });
  out["confirmed_flips"] = column<int>(shapes, [](const auto& s) { return s.confirmed_flips; });
  out["degenerate"] = column<int>(shapes, [](const auto& s) { return s.degenerate; });
  out["opposing_mean"] = column<int>(shapes, [](const auto& s) { return s.opposing_mean; });
  out["self_intersections"] = column<int>(shapes, [](const auto& s) { return s.self_intersections; });
  out["input_self_intersections"] =
      column<int>(shapes, [](const auto& s) { return s.input_self_intersections; });
  return out;
}

py::dict summary_of(const ErrorSummary& error) {
  py::dict out;
  out["mean"] = error.mean;
  out["p95"] = error.p95;
  out["max"] = error.max;
  return out;
}

py::object truth_of(const std::optional<TruthError>& truth) {
  if (!truth) return py::none();
  py::dict out;
  out["error"] = summary_of(truth->error);
  out["floor"] = summary_of(truth->floor);
  out["mean_from_shape"] = column(truth->mean_from_shape, [](double mean) { return mean; });
  return out;
}

py::dict evaluation_dict(const Evaluation& e) {
  py::dict out;
  out["names"] = e.names;
  out["subjects"] = e.subjects;
  out["landmarks"] = e.landmarks;
  out["total_variance"] = e.total_variance;
  out["compactness"] = compactness_of(e.compactness);
  out["generalization"] = model_errors(e.leave_one_out.by_modes);
  out["generalization_by_subject"] =
      e.leave_subject_out ? py::object(model_errors(e.leave_subject_out->by_modes)) : py::none();
  out["specificity"] = model_errors(e.specificity.by_modes);
  out["ensemble"] = ensemble_of(e.ensemble);
  out["drawn"] = drawn_of(e.drawn);
  out["representation"] = representation_of(e.representation.shapes);
  out["truth"] = truth_of(e.truth);
  out["marks"] = e.marks ? py::object(py::str(marks_json(*e.marks, e.names).dump())) : py::none();
  out["regions"] = e.regions ? py::object(py::str(regions_json(*e.regions, e.names).dump())) : py::none();
  return out;
}

// The original surfaces of the shapes, found by name. If none are given, the corresponding meshes.
std::vector<Mesh> originals(const CorrespondingCohort& cohort, const GivenShapes* given) {
  std::vector<Mesh> meshes;
  for (std::size_t i = 0; i < cohort.names.size(); ++i)
    meshes.push_back(given != nullptr ? shape_named(given->shapes, cohort.names[i]).mesh
                                      : build_mesh({cohort.corresponding[i], cohort.triangles}));
  return meshes;
}

// A mark as Python gives it: name, kind and points.
using GivenMark = std::tuple<std::string, std::string, PointArray>;

MarksOfShape marks_of(const std::vector<GivenMark>& given) {
  MarksOfShape marks;
  for (const auto& [name, word, points] : given) {
    const auto kind = value_of<MarkKind>(word);
    if (!kind) throw InvalidInput("the mark '" + name + "' is none of point, open, closed, but " + word);
    marks.push_back({name, *kind, soup_of(points, TriangleArray(std::vector<py::ssize_t>{0, 3})).points});
  }
  return marks;
}

py::dict evaluate_in_memory(const std::vector<std::string>& names, const PointArray& corresponding,
                            const TriangleArray& triangles, const GivenShapes* given,
                            const std::vector<std::string>& subjects, const std::string& subject_regex,
                            const std::optional<std::pair<PointArray, TriangleArray>>& truth,
                            const std::vector<std::vector<GivenMark>>& given_marks,
                            const std::vector<std::vector<int>>& labels, const py::dict& given_options,
                            int threads, const py::object& progress) {
  EvaluationOptions options;
  set_options(options, given_options, "evaluate");
  const auto corners = [](const TriangleArray& array) {
    return soup_of(PointArray(std::vector<py::ssize_t>{0, 3}), array).triangles;
  };
  CorrespondingCohort cohort{names, subjects, corners(triangles), shapes_of(corresponding), {}};
  if (names.size() != cohort.corresponding.size())
    throw InvalidInput(std::to_string(names.size()) + " names for " +
                       std::to_string(cohort.corresponding.size()) + " shapes");
  if (!subject_regex.empty())
    for (const std::string& name : names) cohort.subjects.push_back(subject_of(name, subject_regex));
  std::optional<TrueCorrespondence> known;
  if (truth) known = TrueCorrespondence{corners(truth->second), shapes_of(truth->first)};
  std::vector<MarksOfShape> marks;
  std::vector<RegionsOfShape> regions;
  for (const auto& of_shape : given_marks) marks.push_back(marks_of(of_shape));
  for (const auto& of_shape : labels) regions.push_back(regions_of_labels(of_shape));
  Evaluation evaluation;
  run_unlocked(threads, progress, [&](const RunContext& ctx) {
    cohort.inputs = originals(cohort, given);
    std::optional<MarkTransfer> of_marks;
    std::optional<RegionTransfer> of_regions;
    if (!marks.empty()) of_marks = mark_transfer(cohort, marks, ctx);
    if (!regions.empty()) of_regions = region_transfer(cohort, regions, ctx);
    evaluation = evaluate(cohort, options, ctx, known ? &*known : nullptr);
    evaluation.marks = std::move(of_marks);
    evaluation.regions = std::move(of_regions);
  });
  return evaluation_dict(evaluation);
}

}  // namespace

void add_evaluation(py::module_& module) { module.def("evaluate_in_memory", &evaluate_in_memory); }

}  // namespace foramen::python
