#pragma once
/// \file
/// Generalization: how well a model describes a shape that is not in its training set.

#include <cstdint>
#include <string>
#include <vector>

#include "foramen/core/run_context.hpp"
#include "foramen/evaluate/cohort.hpp"
#include "foramen/model/build_shape_model.hpp"

namespace foramen {

/// Which shapes are left out of a model together.
enum class LeaveOut {
  shape,   ///< one shape at a time
  subject  ///< all shapes of one subject at a time, because they are not independent
};
template <>
struct EnumWords<LeaveOut> {
  static constexpr std::pair<std::string_view, LeaveOut> all[] = {{"shape", LeaveOut::shape},
                                                                  {"subject", LeaveOut::subject}};
};

struct GeneralizationOptions {
  LeaveOut leave_out = LeaveOut::shape;
  ScaleMode scale = ScaleMode::keep;
  /// Landmark weights. They are computed from the whole cohort and are the same for all models, because they
  /// also define the error.
  LandmarkWeights weights = LandmarkWeights::equal;
  int samples = 20000;
  std::uint64_t seed = 1;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<GeneralizationOptions> auto& o) {
  visit(o.leave_out,
        {.name = "leave_out", .meaning = "whether a shape or all shapes of a subject are left out"});
  visit(o.scale, {.name = "scale", .meaning = "keep or remove the shapes' size"});
  visit(o.weights,
        {.name = "landmark_weights", .meaning = "what landmarks count for: all alike, or by their area"});
  visit(o.samples, {.name = "surface_samples",
                    .range = at_least(1),
                    .meaning = "samples of each surface for its distances"});
  visit(o.seed, {.name = "seed", .meaning = "seed of those samples"});
}

/// Leave-one-out errors by number of modes.
struct Generalization {
  LeaveOut leave_out = LeaveOut::shape;
  int groups = 0;                       ///< number of models that were built: one per shape or subject
  std::vector<ErrorsAtModes> by_modes;  ///< items are in the order of the cohort's shapes
};

/// \f$ G(M) = \frac{1}{n} \sum_i d(\mathrm{input}_i, \hat x_i(M)) \f$ \cite davies2008. The alignment and the
/// PCA are computed without the left-out shapes. Shape i is then aligned to the mean of this model and
/// projected on M modes, and the reconstruction is compared with the original input surface, transformed by
/// the same alignment. The standard error is s / sqrt(n) over shapes. M goes up to the number of modes that
/// the smallest of these models can have, which is n - 2 if one shape is left out. A model with fewer modes
/// (linearly dependent shapes) is used with all its modes. The correspondence is not recomputed, so it
/// depends on the left-out shape; see RefitGeneralization. Throws InvalidInput for fewer than 3 shapes, and
/// with LeaveOut::subject if subjects are unknown or fewer than 2 shapes remain without one.
Generalization generalization(const CorrespondingCohort& cohort, const GeneralizationOptions& options,
                              const RunContext& ctx);

/// The groups of shapes (indices) that are left out together: single shapes, or the shapes of each subject in
/// the order of their first shapes.
/// \param subjects  one per shape; ignored for LeaveOut::shape
std::vector<std::vector<int>> left_out_together(int shapes, const std::vector<std::string>& subjects,
                                                LeaveOut leave_out);

/// The errors d(input, x(M)) of one shape that is not in the model, for each number of modes M in `counts`.
/// \param landmarks, input  landmarks and surface of the shape in its own coordinates, mm
std::vector<ShapeError> unseen_errors(const std::vector<Vec3>& landmarks, const Mesh& input,
                                      const AlignedModel& aligned, const std::vector<int>& counts,
                                      const GeneralizationOptions& options);

/// The estimates over shapes for each number of modes, from the errors of each shape; empty without shapes.
std::vector<ErrorsAtModes> over_shapes(const std::vector<std::vector<ShapeError>>& errors,
                                       const std::vector<int>& counts);

/// Generalization of the whole method: as generalization(), but the correspondence is also computed without
/// the left-out shapes, which are then registered to the model built without them.
struct RefitGeneralization {
  struct Failure {
    std::string shape;    ///< the shape that could not be registered
    std::string without;  ///< the build: the shape or subject that it left out
    std::string reason;
  };
  Generalization generalization;   ///< items are in the order of `names`
  std::vector<std::string> names;  ///< shapes that were registered
  /// Left-out shapes that failed have no item; other failed shapes were missing in that model.
  std::vector<Failure> failures;
};

}  // namespace foramen
