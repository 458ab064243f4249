#pragma once
/// \file
/// From surfaces to a statistical shape model: the whole way on one screen.

#include <optional>
#include <string>
#include <vector>

#include "foramen/groupwise/register_group.hpp"
#include "foramen/model/landmark_weights.hpp"
#include "foramen/model/procrustes.hpp"
#include "foramen/model/shape_model.hpp"
#include "foramen/pipeline/read_cohort.hpp"
#include "foramen/resample/error_density.hpp"
#include "foramen/resample/remesh.hpp"

namespace foramen {

enum class Method {
  torus,  ///< correspondence through maps to a common flat torus
  icp,  ///< the baseline (Brett and Taylor 2000): landmarks of the remeshed reference to their closest points
};

/// What draws the maps of Method::torus into correspondence.
enum class Objective {
  surface,     ///< points of a template bent onto the shape; the template becomes the mean: register_group()
  neighbours,  ///< the paper's soft neighbours on the reference [becker2011 Eq. 4]: register_shape()
};

struct BuildOptions {
  Method method = Method::torus;
  Objective objective = Objective::surface;
  std::string reference = "auto";     ///< A shape's stem, or auto: the first of rank_references() with a map.
  RegisterOptions registration = {};  ///< of the reference, and of all shapes with Objective::neighbours
  RegisterGroupOptions group = {};    ///< of all shapes with Objective::surface
  int landmarks = 4000;               ///< Budget; refinement may add 5 %.
  std::optional<double> target_error_mm =
      std::nullopt;                 ///< Set: as few landmarks as give this mean representation error [mm].
  int grid_points = 65000;          ///< Of the dense uniform sampling of the torus.
  RemeshOptions remeshing = {};     ///< (its number of landmarks is set from the above)
  ErrorDensityOptions errors = {};  ///< what raises the density of landmarks, as often as this:
  int density_updates = 3;
  ScaleMode scale = ScaleMode::keep;
  LandmarkWeights weights = LandmarkWeights::equal;  ///< in the alignment and the model
  std::uint64_t seed = 1;
};

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

/// Whether shapes are registered as a group, and options.group counts.
bool registered_together(const BuildOptions& options);

/// Throws InvalidInput if fewer than three shapes are usable or the named reference is not among them. A
/// shape whose registration fails is left out with the reason.
ModelBuild build_model(Cohort cohort, const BuildOptions& options, const RunContext& ctx);

/// The shapes from the most ordinary on, by a cheap rule: smallest sum of absolute deviations of log area and
/// log volume from the cohort's medians. Equals in their order; shapes of more than 100 000 vertices, whose
/// loops take minutes, last.
std::vector<int> rank_references(const std::vector<InputShape>& shapes);

}  // namespace foramen
