#pragma once
/// \file
/// Generalization: how well a model describes a shape it has not seen.

#include <cstdint>
#include <string>
#include <vector>

#include "foramen/core/run_context.hpp"
#include "foramen/evaluate/cohort.hpp"
#include "foramen/model/build_shape_model.hpp"

namespace foramen {

enum class LeaveOut {
  shape,   ///< one shape at a time
  subject  ///< all shapes of one subject at a time: shapes of one subject are not independent
};
template <>
struct EnumWords<LeaveOut> {
  static constexpr std::pair<std::string_view, LeaveOut> all[] = {{"shape", LeaveOut::shape},
                                                                  {"subject", LeaveOut::subject}};
};

struct GeneralizationOptions {
  LeaveOut leave_out = LeaveOut::shape;
  ScaleMode scale = ScaleMode::keep;
  /// Those of the whole cohort, the same with whichever shape left out: they are part of how errors are
  /// measured.
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

struct Generalization {
  LeaveOut leave_out = LeaveOut::shape;
  int groups = 0;                       ///< models that were built: shapes, or subjects
  std::vector<ErrorsAtModes> by_modes;  ///< items in the order of the cohort's shapes
};

/// \f$ G(M) = \frac{1}{n} \sum_i d(\mathrm{input}_i, \hat x_i(M)) \f$ \cite davies2008. The alignment and the
/// PCA are made without the shapes left out; shape i is then aligned to that mean, projected on M modes, and
/// the reconstruction compared with its original input surface, moved by the same alignment. The standard
/// error is s / sqrt(n) over shapes. M runs to the modes the smallest of these models can have: n - 2 when
/// one shape is left out. A model that has fewer (dependent shapes) is used with those it has. The
/// correspondence is not computed anew: it has seen the shape. Throws InvalidInput: fewer than 3 shapes;
/// subjects unknown, or so few that 2 shapes do not remain.
Generalization generalization(const CorrespondingCohort& cohort, const GeneralizationOptions& options,
                              const RunContext& ctx);

/// Which shapes (indices) leave the model together: each alone, or those of one subject, in order of its
/// first shape.
/// \param subjects  one per shape; not looked at for LeaveOut::shape
std::vector<std::vector<int>> left_out_together(int shapes, const std::vector<std::string>& subjects,
                                                LeaveOut leave_out);

/// d(input, x(M)) of one shape that is not in the model, for each of the numbers of modes.
/// \param landmarks, input  in the shape's own coordinates, mm
std::vector<ShapeError> unseen_errors(const std::vector<Vec3>& landmarks, const Mesh& input,
                                      const AlignedModel& aligned, const std::vector<int>& counts,
                                      const GeneralizationOptions& options);

/// From the errors of each shape at all numbers of modes to the estimates over shapes; nothing without
/// shapes.
std::vector<ErrorsAtModes> over_shapes(const std::vector<std::vector<ShapeError>>& errors,
                                       const std::vector<int>& counts);

/// Generalization of the whole method: as generalization(), but the correspondence too is computed without
/// the shapes left out; they are then registered to the model built without them.
struct RefitGeneralization {
  struct Failure {
    std::string shape;    ///< that could not be registered
    std::string without;  ///< in the build that left this shape or subject out
    std::string reason;
  };
  Generalization generalization;   ///< items in the order of these names:
  std::vector<std::string> names;  ///< shapes that entered
  std::vector<Failure> failures;   ///< a shape of `without` has not entered; others were not in that model
};

}  // namespace foramen
