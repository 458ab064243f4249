#pragma once
/// \file
/// The input of an evaluation: corresponding meshes and the original surfaces.

#include <array>
#include <string>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/shape.hpp"
#include "foramen/landmarks/place_landmarks.hpp"
#include "foramen/model/landmark_weights.hpp"
#include "foramen/model/procrustes.hpp"
#include "foramen/model/shape_model.hpp"

namespace foramen {

struct CorrespondingCohort {
  std::vector<std::string> names;             ///< one per shape
  std::vector<std::string> subjects;          ///< the subject of each shape; empty: not known
  std::vector<std::array<int, 3>> triangles;  ///< of landmarks, the same for all shapes
  std::vector<std::vector<Vec3>>
      corresponding;         ///< landmarks of each shape, in the coordinates of its input, mm
  std::vector<Mesh> inputs;  ///< the original surfaces, mm

  int size() const { return static_cast<int>(corresponding.size()); }
  int landmarks() const { return corresponding.empty() ? 0 : static_cast<int>(corresponding[0].size()); }
};

/// The cohort of placed landmarks and their shapes.
/// \param subjects  one per shape of `landmarks`, or empty
/// Throws InvalidInput if a shape is missing.
CorrespondingCohort corresponding_cohort(std::span<const Shape> shapes, const Landmarks& landmarks,
                                         std::vector<std::string> subjects = {});

/// Throws InvalidInput unless there are at least 3 shapes, all vectors have one entry per shape, all shapes
/// have the same number of landmarks, and the landmarks of each shape form a manifold mesh with the
/// triangles. The message names the shape.
void check_cohort(const CorrespondingCohort& cohort);

/// The mesh of landmarks of one shape, in the coordinates of its input.
Mesh corresponding_mesh(const CorrespondingCohort& cohort, int shape);

/// A cohort in model coordinates and its model.
struct AlignedCohort {
  ProcrustesResult alignment;
  std::vector<Mesh> inputs;  ///< the original surfaces, transformed by the alignment of each shape
  ShapeModel model;
};
/// Procrustes alignment and PCA of all shapes. \pre check_cohort(cohort) passes
AlignedCohort align_cohort(const CorrespondingCohort& cohort, ScaleMode scale,
                           LandmarkWeights weights = LandmarkWeights::equal);

/// The surface transformed by a similarity.
Mesh transformed(const Mesh& mesh, const SimilarityTransform& transform);

/// The numbers of modes M for which measures are reported: 1 .. 20, then powers of two, and the last. Empty
/// if last < 1.
std::vector<int> mode_counts(int last);

/// A mean with its standard error s / sqrt(n), s with divisor n - 1 (0 for a single value).
struct Estimate {
  double mean = 0;
  double standard_error = 0;
};
/// \pre at least one value
Estimate estimate(const std::vector<double>& values);

/// Three distances between a shape of the model and a training shape, mm.
struct ShapeError {
  double hausdorff = 0;     ///< to the original input surface, as SurfaceDistance::hausdorff
  double mean_surface = 0;  ///< to the original input surface, as SurfaceDistance::mean
  double landmark_rms = 0;  ///< ShapeModel::landmark_rms of corresponding landmarks
};

/// The ShapeErrors of many shapes or draws for one number of modes.
struct ErrorsAtModes {
  int modes = 0;
  std::vector<ShapeError> items;  ///< one per shape (generalization) or draw (specificity)
  Estimate hausdorff, mean_surface, landmark_rms;
};
/// Computes the estimates from the items.
ErrorsAtModes errors_at_modes(int modes, std::vector<ShapeError> items);

}  // namespace foramen
