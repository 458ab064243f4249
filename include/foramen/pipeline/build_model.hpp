#pragma once
/// \file
/// From surfaces to a statistical shape model: the whole way on one screen.

#include <optional>
#include <string>
#include <vector>

#include "foramen/core/options.hpp"
#include "foramen/correspond/register_group.hpp"
#include "foramen/model/landmark_weights.hpp"
#include "foramen/model/procrustes.hpp"
#include "foramen/model/shape_model.hpp"
#include "foramen/pipeline/read_cohort.hpp"
#include "foramen/sampling/curvature_density.hpp"
#include "foramen/sampling/error_density.hpp"
#include "foramen/sampling/remesh.hpp"

namespace foramen {

enum class Method {
  torus,  ///< correspondence through maps to a common flat torus
  icp,  ///< the baseline (Brett and Taylor 2000): landmarks of the remeshed reference to their closest points
};
template <>
struct EnumWords<Method> {
  static constexpr std::pair<std::string_view, Method> all[] = {{"torus", Method::torus},
                                                                {"icp", Method::icp}};
};

/// What draws the maps of Method::torus into correspondence.
enum class Objective {
  surface,     ///< points of a template bent onto the shape; the template becomes the mean: register_group()
  neighbours,  ///< the paper's soft neighbours on the reference [becker2011 Eq. 4]: register_shape()
};
template <>
struct EnumWords<Objective> {
  static constexpr std::pair<std::string_view, Objective> all[] = {{"surface", Objective::surface},
                                                                   {"neighbours", Objective::neighbours}};
};

struct CorrespondOptions {
  Method method = Method::torus;
  Objective objective = Objective::surface;
  std::string reference = "auto";     ///< A shape's stem, or auto: the first of rank_references() with a map.
  RegisterGroupOptions group = {};    ///< of all shapes with Objective::surface
  RegisterOptions registration = {};  ///< of the reference, and of all shapes with Objective::neighbours
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<CorrespondOptions> auto& o) {
  visit(o.method, {.name = "method", .meaning = "torus maps, or the ICP baseline"});
  visit(
      o.objective,
      {.name = "objective",
       .meaning =
           "what draws the maps together: points of the bent mean's surface, or the paper's soft neighbours"});
  visit(o.reference, {.name = "reference", .meaning = "name of the reference shape, or auto"});
  visit(o.group, {.name = "group"});
  visit(o.registration, {.name = "registration"});
}

/// Whether shapes are registered as a group, and options.group counts.
bool registered_together(const CorrespondOptions& options);

/// How landmarks are spread over the mean.
struct LandmarkSpreadOptions {
  int grid_points = 65000;
  CurvatureDensityOptions density = {};
  int relaxation_rounds = RemeshOptions{}.relaxation_rounds;
  int density_updates = 3;
  ErrorDensityOptions errors = {};
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<LandmarkSpreadOptions> auto& o) {
  visit(o.grid_points, {.name = "grid_points",
                        .range = at_least(16),
                        .meaning = "points of the dense uniform sampling of the torus"});
  visit(o.density, {.nesting = Nesting::inlined});
  visit(o.relaxation_rounds,
        {.name = "relaxation_rounds", .range = at_least(0), .meaning = "rounds of Lloyd relaxation"});
  visit(o.density_updates, {.name = "density_updates",
                            .range = at_least(0),
                            .meaning = "times that the density is raised where the landmarks miss a shape"});
  visit(o.errors, {.nesting = Nesting::inlined});
}

struct PlaceLandmarksOptions {
  int count = 4000;
  std::optional<double> target_error_mm =
      std::nullopt;  ///< Set: it decides the number, and `count` does not.
  ScaleMode scale = ScaleMode::keep;
  std::uint64_t seed = 1;
  LandmarkSpreadOptions spread = {};
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<PlaceLandmarksOptions> auto& o) {
  visit(o.count, {.name = "landmarks",
                  .range = at_least(50).up_to(200000),
                  .meaning = "number of landmarks (refinement may add 5 %)"});
  visit(o.target_error_mm, {.name = "target_error",
                            .unit = "mm",
                            .range = above(0),
                            .meaning = "as few landmarks as represent the shapes this well"});
  visit(o.scale, {.name = "scale",
                  .meaning = "keep or remove the shapes' size in the mean on which landmarks are placed"});
  visit(o.seed,
        {.name = "seed", .meaning = "seed of the samples by which the error of representation is measured"});
  visit(o.spread, {.name = "resampling"});
}

struct ShapeModelOptions {
  ScaleMode scale = ScaleMode::keep;
  LandmarkWeights weights = LandmarkWeights::equal;  ///< in the alignment and the model
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<ShapeModelOptions> auto& o) {
  visit(o.scale, {.name = "scale", .meaning = "keep or remove the shapes' size"});
  visit(o.weights,
        {.name = "landmark_weights", .meaning = "what landmarks count for: all alike, or by their area"});
}

/// The options of each stage.
struct BuildOptions {
  CorrespondOptions correspondence = {};
  PlaceLandmarksOptions landmarks = {};
  ShapeModelOptions model = {};
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<BuildOptions> auto& o) {
  visit(o.correspondence, {.name = "correspondence"});
  visit(o.landmarks, {.name = "landmarks"});
  visit(o.model, {.name = "model"});
}

/// What became of one input.
struct ShapeOutcome {
  InputShape input;
  RegisteredShape
      registration;  ///< identity for the reference; alignment only for ICP. Its map is let go of as soon as
                     ///< the landmarks are placed: a cohort of large shapes has no room for all of them.
  std::vector<Vec3> landmarks;  ///< on its input surface, in the input's coordinates, mm
  int unmatched = 0;            ///< ICP: landmarks without a normal-compatible point on this shape
  double seconds = 0;           ///< of registration
};

struct ModelBuild {
  std::vector<ShapeOutcome> shapes;  ///< used, in order of stem
  std::vector<LeftOut> left_out;
  std::vector<std::string> notes;  ///< what the user should know though it is no error
  int reference = 0;               ///< index into shapes
  Reference reference_map;
  LandmarkMesh landmarks;
  int inserted_landmarks = 0;  ///< added to the budget by refinement
  int remaining_flips =
      0;  ///< confirmed-flipped or degenerate landmark triangles, over all shapes; must be 0
  /// Pairs of landmark triangles that meet, over all shapes whose input does not meet itself: before they
  /// were mended, and left.
  int initial_self_intersections = 0, remaining_self_intersections = 0;
  ProcrustesResult procrustes;
  ShapeModel model;
  std::vector<double> template_motion_mm;   ///< see GroupRegistration
  std::vector<double> unexplained_shares;   ///< the same
  std::vector<double> description_lengths;  ///< the same
  GroupTemplate group_template;             ///< of Objective::surface
  std::vector<std::pair<std::string, double>> stage_seconds;
};

/// Throws InvalidInput if fewer than three shapes are usable or the named reference is not among them. A
/// shape whose registration fails is left out with the reason.
ModelBuild build_model(Cohort cohort, const BuildOptions& options, const RunContext& ctx);

/// The shapes from the most ordinary on, by a cheap rule: smallest sum of absolute deviations of log area and
/// log volume from the cohort's medians. Equals in their order; shapes of more than 100 000 vertices, whose
/// loops take minutes, last.
std::vector<int> rank_references(const std::vector<InputShape>& shapes);

}  // namespace foramen
