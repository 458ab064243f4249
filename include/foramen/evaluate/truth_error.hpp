#pragma once
/// \file
/// The error of a correspondence where the true one is known.

#include <array>
#include <vector>

#include "foramen/core/run_context.hpp"
#include "foramen/evaluate/cohort.hpp"

namespace foramen {

/// True correspondence: meshes of the same triangles, whose same barycentric places are the same anatomical
/// places.
struct TrueCorrespondence {
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::vector<Vec3>> shapes;  ///< one per shape of the cohort, in its input's coordinates, mm
};

struct ErrorSummary {
  double mean = 0, p95 = 0, max = 0;  ///< mm
};

struct TruthError {
  ErrorSummary error;  ///< over landmarks and ordered pairs of shapes
  ErrorSummary floor;  ///< what perfect landmarks get under the same measure
  std::vector<double>
      mean_from_shape;  ///< over landmarks and partners, for the pairs that start at each shape, mm
};

/// Landmark i of shape A is projected onto the truth mesh of A (closest point), taken to the same place of
/// the truth mesh of B, and its distance to landmark i of B measured; for all ordered pairs A != B. The floor
/// is the same for true landmarks: those of the first shape, carried to every shape by the true map and
/// projected onto the input surface there, as landmarks lie on it; it measures how far truth meshes and
/// inputs are apart. p95: the smallest error that 95 % do not exceed. Throws InvalidInput when the truth does
/// not fit the cohort.
TruthError truth_error(const CorrespondingCohort& cohort, const TrueCorrespondence& truth,
                       const RunContext& ctx);

/// The first shape's landmarks as the true map carries them to every shape, put onto the input surfaces: what
/// a perfect correspondence with these landmarks is, for measures beside the truth error.
std::vector<std::vector<Vec3>> true_landmarks(const CorrespondingCohort& cohort,
                                              const TrueCorrespondence& truth, const RunContext& ctx);

}  // namespace foramen
