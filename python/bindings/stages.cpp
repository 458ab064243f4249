#include <memory>
#include <optional>
#include <utility>

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "bindings.hpp"
#include "core/option_bytes.hpp"
#include "core/parallel.hpp"
#include "foramen/core/error.hpp"
#include "foramen/stages/build_model.hpp"
#include "inputs/read_cohort.hpp"
#include "modelfiles/usable_model.hpp"
#include "options.hpp"
#include "remedy_words.hpp"
#include "workflow/build_choices.hpp"

namespace foramen::python {
namespace {

struct MadeCorrespondence {
  Correspondence correspondence;
  CorrespondOptions options;
};

// The surfaces, audited and wound outward as those that a build reads from files.
GivenShapes given_shapes(const std::vector<std::string>& names, const std::vector<PointArray>& points,
                         const std::vector<TriangleArray>& triangles, const std::vector<std::string>& spaces,
                         int threads, const py::object& progress) {
  struct Audited {
    Mesh mesh;
    Message refusal;
  };
  std::vector<TriangleSoup> soups;
  for (std::size_t i = 0; i < names.size(); ++i) soups.push_back(soup_of(points[i], triangles[i]));
  std::vector<Audited> audited(names.size());
  run_unlocked(threads, progress, [&](const RunContext& ctx) {
    parallel_for(static_cast<int>(names.size()), ctx, [&](int i) {
      Audited& shape = audited[i];
      try {
        shape.mesh = usable_shape({}, std::move(soups[i]), LengthUnit::millimetre).mesh;
      } catch (const InvalidInput& e) {
        shape.refusal = message_of(e);
      }
    });
  });
  GivenShapes given;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (audited[i].refusal.text.empty()) {
      given.shapes.push_back({names[i], std::move(audited[i].mesh)});
      given.spaces.push_back(space_of(spaces[i]));
    } else {
      given.refused.push_back({names[i], audited[i].refusal});
    }
  }
  return given;
}

// Runs a stage. If it throws because there are too few shapes, the message also names those that the audit
// refused.
template <class Stage>
auto with_refused(const GivenShapes& given, const Stage& stage) {
  try {
    return stage();
  } catch (const TooFewShapes& e) {
    Message message = message_of(e);
    for (const FailedShape& shape : given.refused)
      message.append(shape.reason.about("\n  left out " + shape.name));
    throw TooFewShapes(message);
  }
}

py::list failures(const std::vector<FailedShape>& shapes) {
  py::list list;
  for (const FailedShape& shape : shapes) list.append(py::make_tuple(shape.name, worded(shape.reason)));
  return list;
}

py::dict record_of(const ShapeRegistration& shape) {
  py::dict out;
  out["name"] = shape.name;
  out["alignment"] = py::cast(Eigen::Matrix4d(shape.alignment.transform.matrix()));
  out["alignment_residual"] = shape.alignment.residual;
  out["mapped"] = shape.mapped;
  out["flipped"] = shape.certificate.flipped;
  out["iterations"] = shape.iterations;
  out["initial_energy"] = shape.initial_energy;
  out["final_energy"] = shape.final_energy;
  out["distortion"] = shape.distortion;
  out["agreement"] = py::cast(Eigen::Vector2d(shape.agreement));
  out["seconds"] = shape.seconds;
  return out;
}

// The values from which Python's Correspondence is made.
py::dict registration_of(const CohortRegistration& cohort, const GivenShapes& given) {
  std::vector<FailedShape> failed = given.refused;
  failed.insert(failed.end(), cohort.failed.begin(), cohort.failed.end());
  py::list shapes;
  for (const ShapeRegistration& shape : cohort.shapes) shapes.append(record_of(shape));
  py::dict out;
  out["method"] = std::string(word_of(cohort.method));
  out["reference"] = cohort.shapes[cohort.reference].name;
  out["shapes"] = shapes;
  out["failed"] = failures(failed);
  out["refused_references"] = failures(cohort.refused_references);
  out["template_motion"] = cohort.template_motion_mm;
  out["unexplained_shares"] = cohort.unexplained_shares;
  out["description_lengths"] = cohort.description_lengths;
  return out;
}

BuildOptions options_of(const py::dict& chosen) {
  BuildChoices choices;
  set_options(choices, chosen, "build_model");
  return build_options(choices);
}

// Returns the correspondence for the next stages, and its description.
py::tuple correspond_shapes(const GivenShapes& given, const py::dict& chosen, const py::dict& further,
                            int threads, const py::object& progress) {
  auto made = std::make_shared<MadeCorrespondence>();
  made->options = options_of(chosen).correspondence;
  set_options(made->options, further, "correspond");
  run_unlocked(threads, progress, [&](const RunContext& ctx) {
    made->correspondence = with_refused(given, [&] { return correspond(given.shapes, made->options, ctx); });
  });
  return py::make_tuple(made, registration_of(made->correspondence.registration, given));
}

py::dict place(const GivenShapes& given, const MadeCorrespondence& made, const py::dict& chosen,
               const py::dict& further, int threads, const py::object& progress) {
  PlaceLandmarksOptions options = options_of(chosen).landmarks;
  set_options(options, further, "place_landmarks");
  Landmarks landmarks;
  run_unlocked(threads, progress, [&](const RunContext& ctx) {
    landmarks = place_landmarks(given.shapes, made.correspondence, options, ctx);
  });
  PointArray turns({static_cast<py::ssize_t>(landmarks.mesh.turns.size()), py::ssize_t{2}});
  double* turn = turns.mutable_data();
  for (const Vec2& at : landmarks.mesh.turns) turn = std::copy(at.begin(), at.end(), turn);
  py::dict out;
  out["names"] = landmarks.names;
  out["points"] = shapes_array(landmarks.points);
  out["triangles"] = triangles_array(landmarks.mesh.triangles);
  out["turns"] = turns;
  out["inserted"] = landmarks.inserted;
  out["remaining_flips"] = landmarks.remaining_flips;
  out["remaining_self_intersections"] = landmarks.remaining_self_intersections;
  return out;
}

void refuse_choices_of_correspondence(const py::dict& chosen) {
  for (const char* name : {"method", "objective", "rounds", "distortion", "bending", "reference", "lambda",
                           "paper", "initial_map", "optimiser"})
    if (chosen.contains(name))
      throw ChoiceWithoutEffect(name, "has no effect on a correspondence that is finished");
}

// The stages of build_model() after correspond().
BuiltModel built_from(std::span<const Shape> shapes, const Correspondence& correspondence,
                      const BuildOptions& options, const RunContext& ctx) {
  BuiltModel built;
  built.registration = correspondence.registration;
  built.landmarks = place_landmarks(shapes, correspondence, options.landmarks, ctx);
  ctx.step("model", 0);
  built.aligned = build_shape_model(built.landmarks.points, built.landmarks.mesh.triangles, options.model);
  return built;
}

LoadedModel loaded_of(const AlignedModel& aligned, std::vector<std::string> names, AnatomicalSpace space) {
  return {aligned.model, std::move(names), training_scores(aligned), space};
}

py::array_t<double> transforms_array(const std::vector<SimilarityTransform>& transforms) {
  py::array_t<double> out({static_cast<py::ssize_t>(transforms.size()), py::ssize_t{4}, py::ssize_t{4}});
  auto view = out.mutable_unchecked<3>();
  for (py::ssize_t i = 0; i < view.shape(0); ++i) {
    const Eigen::Matrix4d matrix = transforms[i].matrix();
    for (py::ssize_t r = 0; r < 4; ++r)
      for (py::ssize_t c = 0; c < 4; ++c) view(i, r, c) = matrix(r, c);
  }
  return out;
}

// The values from which Python's Model is made: the model, the data for its use, the corresponding points,
// and the transforms.
py::dict model_parts(const std::vector<std::vector<Vec3>>& corresponding, UsableModel usable,
                     LandmarkWeights weights) {
  py::dict out;
  out["scale"] = std::string(word_of(usable.scale));
  out["landmark_weights"] = std::string(word_of(weights));
  out["corresponding"] = shapes_array(corresponding);
  out["transforms"] = transforms_array(usable.aligned.alignment.transforms);
  out["loaded"] = loaded_of(usable.aligned, usable.names, usable.space);
  out["usable"] = std::move(usable);
  return out;
}

// The space of the reference, which is also that of mean.ply.
AnatomicalSpace space_of_reference(const GivenShapes& given, const std::string& reference) {
  for (std::size_t i = 0; i < given.shapes.size(); ++i)
    if (given.shapes[i].name == reference) return given.spaces[i];
  throw InvalidInput("the shape " + reference + " of the correspondence is not among those given");
}

py::dict build_in_memory(const GivenShapes& given, const MadeCorrespondence* made, const py::dict& chosen,
                         const py::dict& further, int threads, const py::object& progress) {
  if (made != nullptr) refuse_choices_of_correspondence(chosen);
  BuildOptions options = options_of(chosen);
  if (made != nullptr) options.correspondence = made->options;
  const std::string before = option_bytes(options.correspondence);
  set_options(options, further, "build_model");
  if (made != nullptr && option_bytes(options.correspondence) != before)
    throw InvalidInput(
        "options of the correspondence have no effect on one that is finished; leave them out");
  BuiltModel built;
  run_unlocked(threads, progress, [&](const RunContext& ctx) {
    built = with_refused(given, [&] {
      return made != nullptr ? built_from(given.shapes, made->correspondence, options, ctx)
                             : build_model(given.shapes, options, ctx);
    });
  });
  const CohortRegistration& registration = built.registration;
  UsableModel usable;
  usable.curvatures = mean_surface(built).curvatures.values();
  usable.aligned = std::move(built.aligned);
  usable.names = built.landmarks.names;
  usable.scale = options.model.scale;
  usable.space = space_of_reference(given, registration.shapes[registration.reference].name);
  usable.landmarks = built.landmarks.mesh;
  usable.lattice = registration.frame.reference.shape_map.map.lattice;
  py::dict out = model_parts(built.landmarks.points, std::move(usable), options.model.weights);
  out["registration"] = registration_of(registration, given);
  return out;
}

void require_indices(const std::vector<std::array<int, 3>>& triangles, std::size_t points) {
  for (const auto& triangle : triangles)
    for (const int corner : triangle)
      if (corner < 0 || static_cast<std::size_t>(corner) >= points)
        throw InvalidInput("triangles: there is no point " + std::to_string(corner) + "; there are " +
                           std::to_string(points));
}

py::dict model_of_points(const PointArray& points, const TriangleArray& triangles,
                         std::vector<std::string> names, const std::string& space, const py::dict& chosen) {
  const std::vector<std::vector<Vec3>> shapes = shapes_of(points);
  const auto corners = soup_of(PointArray(std::vector<py::ssize_t>{0, 3}), triangles).triangles;
  if (shapes.size() < 2)
    throw InvalidInput("a model needs at least 2 shapes, " + std::to_string(shapes.size()) + " given");
  if (names.size() != shapes.size())
    throw InvalidInput(std::to_string(names.size()) + " names for " + std::to_string(shapes.size()) +
                       " shapes");
  require_indices(corners, shapes.front().size());
  const ShapeModelOptions options = options_of(chosen).model;
  UsableModel usable;
  run_unlocked(1, py::none(),
               [&](const RunContext&) { usable.aligned = build_shape_model(shapes, corners, options); });
  usable.names = std::move(names);
  usable.scale = options.scale;
  usable.space = space_of(space);
  usable.landmarks.triangles = corners;
  return model_parts(shapes, std::move(usable), options.weights);
}

}  // namespace

void add_stages(py::module_& module) {
  py::class_<GivenShapes>(module, "Shapes")
      .def(py::init(&given_shapes))
      .def_property_readonly("names",
                             [](const GivenShapes& given) {
                               std::vector<std::string> names;
                               for (const Shape& shape : given.shapes) names.push_back(shape.name);
                               return names;
                             })
      .def_property_readonly("refused", [](const GivenShapes& given) { return failures(given.refused); });
  const py::class_<MadeCorrespondence, std::shared_ptr<MadeCorrespondence>> made(module,
                                                                                 "MadeCorrespondence");
  module.def("correspond", &correspond_shapes);
  module.def("place_landmarks", &place);
  module.def("build_model", &build_in_memory);
  module.def("model_of_points", &model_of_points);
}

}  // namespace foramen::python
