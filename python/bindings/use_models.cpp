#include <filesystem>
#include <memory>
#include <utility>

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <nlohmann/json.hpp>

#include "bindings.hpp"
#include "foramen/core/error.hpp"
#include "inputs/read_cohort.hpp"
#include "modelfiles/measures_file.hpp"
#include "options.hpp"
#include "remedy_words.hpp"
#include "workflow/completion.hpp"
#include "workflow/measure_shapes.hpp"
#include "workflow/surface_projector.hpp"

namespace foramen::python {
namespace {

namespace fs = std::filesystem;

py::array_t<double> array_of(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

std::unique_ptr<SurfaceProjector> projector_of(const UsableModel& model, int threads,
                                               const py::object& progress) {
  if (model.landmarks.turns.empty())
    throw InvalidInput("this model was made of points and has no map; to project, build it from surfaces");
  std::unique_ptr<SurfaceProjector> projector;
  run_unlocked(threads, progress,
               [&](const RunContext& ctx) { projector = std::make_unique<SurfaceProjector>(model, ctx); });
  return projector;
}

// Returns landmarks, scores, fit, residual, fit_residual, and the figures as JSON.
py::tuple project(const SurfaceProjector& projector, const PointArray& points, const TriangleArray& triangles,
                  const std::vector<std::string>& left_out, const py::object& progress) {
  TriangleSoup soup = soup_of(points, triangles);
  Projection found;
  run_unlocked(1, progress, [&](const RunContext& ctx) {
    ctx.step("project", 0);
    const InputShape shape = usable_shape({}, std::move(soup), LengthUnit::millimetre);
    found = projector(shape.mesh, left_out, ctx);
    ctx.step("project", 1);
  });
  return py::make_tuple(points_array(found.landmarks), found.shape.scores, points_array(found.shape.fit),
                        array_of(found.residual), array_of(found.fit_residual),
                        text_of(projection_json(found)));
}

// Returns points, standard deviations, seen, figures as JSON, a note or None, and the posterior.
py::tuple complete(const UsableModel& model, const PointArray& points, const TriangleArray& triangles,
                   const std::string& space, double noise_mm, double beyond_modes, const py::dict& further,
                   int threads, const py::object& progress) {
  TriangleSoup soup = soup_of(points, triangles);
  CompleteSurfaceOptions options;
  options.noise_mm = noise_mm;
  options.beyond_modes = beyond_modes;
  options.scale = model.scale;
  set_options(options, further, "complete");
  CompletedSurface completed;
  LoadedModel posterior;
  posterior.space = space_of(space);
  run_unlocked(threads, progress, [&](const RunContext& ctx) {
    ctx.step("complete", 0);
    completed = complete_surface(usable_part(std::move(soup), InputUnit(), model.aligned.model).mesh,
                                 model.aligned.model, ctx, options);
    posterior.model = principal_model(completed.shape, model.landmarks.triangles);
    posterior.scores.resize(posterior.model.modes(), 0);
    ctx.step("complete", 1);
  });
  py::array_t<bool> seen(static_cast<py::ssize_t>(completed.seen.size()));
  for (std::size_t i = 0; i < completed.seen.size(); ++i)
    seen.mutable_at(static_cast<py::ssize_t>(i)) = completed.seen[i];
  return py::make_tuple(
      points_array(unflattened(completed.shape.mean)), array_of(standard_deviations(completed.shape)), seen,
      text_of(completion_json(completed)), completion_note(completed), std::move(posterior));
}

// The measures of N shapes by their names: points (N, 3), distances (N,), areas (N,).
py::tuple arrays_of(const MeasureDefinitions& definitions, const std::vector<ShapeMeasures>& all) {
  const auto shapes = static_cast<py::ssize_t>(all.size());
  const auto column = [&](const auto& value_of) {
    py::array_t<double> values(shapes);
    for (py::ssize_t i = 0; i < shapes; ++i) values.mutable_at(i) = value_of(all[i]);
    return values;
  };
  py::dict points, distances, areas;
  for (std::size_t k = 0; k < definitions.points.size(); ++k) {
    std::vector<Vec3> places;
    places.reserve(all.size());
    for (const ShapeMeasures& one : all) places.push_back(one.points[k]);
    points[py::str(definitions.points[k].name)] = points_array(places);
  }
  for (std::size_t k = 0; k < definitions.distances.size(); ++k)
    distances[py::str(definitions.distances[k].name)] =
        column([&](const ShapeMeasures& one) { return one.distances[k]; });
  for (std::size_t k = 0; k < definitions.regions.size(); ++k)
    areas[py::str(definitions.regions[k].name)] =
        column([&](const ShapeMeasures& one) { return one.areas[k]; });
  return py::make_tuple(points, distances, areas);
}

// Definitions, given as a JSON file or as the text of one.
struct Definitions {
  MeasureDefinitions measures;
  std::string source;

  Definitions(const std::string& file, const std::string& text)
      : measures(file.empty() ? parse_measures(text) : read_measures(file)),
        source(file.empty() ? "definitions" : file) {}
};

// Returns names, points, distances and areas.
py::tuple measure_meshes(const LoadedModel& loaded, const std::string& file, const std::string& text,
                         const std::vector<std::string>& inputs, const std::optional<std::string>& unit,
                         const py::object& progress) {
  const InputUnit in_unit = unit_named(unit);
  const Definitions definitions(file, text);
  MeasuredFiles measured;
  run_unlocked(1, progress, [&](const RunContext& ctx) {
    const Measurer measurer = measurer_of(loaded.model, definitions.measures, definitions.source);
    measured = measure_files(measurer, {inputs.begin(), inputs.end()}, in_unit, ctx);
  });
  warn(measured.notes);
  std::vector<std::string> names;
  std::vector<ShapeMeasures> measures;
  for (MeasuredShape& shape : measured.shapes) {
    names.push_back(std::move(shape.name));
    measures.push_back(std::move(shape.measures));
  }
  return py::make_tuple(names) + arrays_of(definitions.measures, measures);
}

// Returns points, distances and areas of an array (N, P, 3).
py::tuple measure_landmarks(const LoadedModel& loaded, const std::string& file, const std::string& text,
                            const PointArray& shapes, const py::object& progress) {
  if (shapes.ndim() != 3 || shapes.shape(2) != 3)
    throw InvalidInput("shapes must be an array of shape (N, P, 3) or (P, 3)");
  const Definitions definitions(file, text);
  const auto count = static_cast<std::size_t>(shapes.shape(0)),
             landmarks = static_cast<std::size_t>(shapes.shape(1));
  const double* const values = shapes.data();
  std::vector<ShapeMeasures> all;
  run_unlocked(1, progress, [&](const RunContext& ctx) {
    const Measurer measurer = measurer_of(loaded.model, definitions.measures, definitions.source);
    std::vector<Vec3> shape(landmarks);
    for (std::size_t i = 0; i < count; ++i) {
      ctx.step("measure", static_cast<double>(i) / static_cast<double>(count));
      for (std::size_t p = 0; p < landmarks; ++p)
        shape[p] = Eigen::Map<const Vec3>(values + 3 * (i * landmarks + p));
      all.push_back(measurer(shape));
    }
  });
  return arrays_of(definitions.measures, all);
}

}  // namespace

void add_model_uses(py::module_& module) {
  py::class_<UsableModel>(module, "UsableModel")
      .def(py::init([](const LoadedModel& loaded, const std::string& folder) {
        const py::gil_scoped_release unlocked;
        return usable_model(loaded, folder);
      }))
      .def("complete", &complete);
  py::class_<SurfaceProjector>(module, "SurfaceProjector")
      .def(py::init(&projector_of))
      .def("project", &project);
  module.def("measure_meshes", &measure_meshes);
  module.def("measure_landmarks", &measure_landmarks);
}

}  // namespace foramen::python
