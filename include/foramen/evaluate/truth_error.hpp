#pragma once
/// \file
/// The error of a correspondence if the true correspondence is known.

#include <array>
#include <vector>

#include "foramen/core/run_context.hpp"
#include "foramen/evaluate/cohort.hpp"

namespace foramen {

/// The true correspondence: meshes with the same triangles, in which points with the same triangle and
/// barycentric coordinates correspond.
struct TrueCorrespondence {
  std::vector<std::array<int, 3>> triangles;
  /// Vertices of one mesh per shape of the cohort, in the coordinates of its input, mm.
  std::vector<std::vector<Vec3>> shapes;
};

/// Summary of a set of errors.
struct ErrorSummary {
  double mean = 0, p95 = 0, max = 0;  ///< mm
};

/// The result of truth_error().
struct TruthError {
  ErrorSummary error;  ///< over landmarks and ordered pairs of shapes
  ErrorSummary floor;  ///< the same measure for perfect landmarks
  /// Per shape: the mean over landmarks and partners for the pairs that start at this shape, mm.
  std::vector<double> mean_from_shape;
};

/// For all ordered pairs of shapes A != B, landmark i of A is projected to the closest point of the truth
/// mesh of A and mapped to the corresponding point of the truth mesh of B; its error is the distance to
/// landmark i of B. The floor is the same for the landmarks of true_landmarks(). It is not 0 because truth
/// meshes and input surfaces differ. p95 is the smallest error that 95 % of the errors do not exceed. Throws
/// InvalidInput if the truth does not fit the cohort.
TruthError truth_error(const CorrespondingCohort& cohort, const TrueCorrespondence& truth,
                       const RunContext& ctx);

/// Landmarks in perfect correspondence: those of the first shape, mapped to every shape by the true
/// correspondence and projected to the input surface.
std::vector<std::vector<Vec3>> true_landmarks(const CorrespondingCohort& cohort,
                                              const TrueCorrespondence& truth, const RunContext& ctx);

}  // namespace foramen
