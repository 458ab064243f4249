#pragma once
/// \file
/// What is evaluated: meshes in correspondence and the surfaces they were made from.

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
  std::vector<std::string> subjects;          ///< whose shape it is; empty: not known
  std::vector<std::array<int, 3>> triangles;  ///< of landmarks, the same for all shapes
  std::vector<std::vector<Vec3>>
      corresponding;         ///< landmarks of each shape, in its input's own coordinates, mm
  std::vector<Mesh> inputs;  ///< the original surfaces, mm

  int size() const { return static_cast<int>(corresponding.size()); }
  int landmarks() const { return corresponding.empty() ? 0 : static_cast<int>(corresponding[0].size()); }
};

/// The shapes of a placement of landmarks. \param subjects  one per shape of it, or empty
/// Throws InvalidInput if a shape is missing.
CorrespondingCohort corresponding_cohort(std::span<const Shape> shapes, const Landmarks& landmarks,
                                         std::vector<std::string> subjects = {});

/// Throws InvalidInput, naming the shape, unless there are at least 3 shapes, all parts have one entry per
/// shape, all shapes have the same number of landmarks, and the triangles form a manifold mesh of them.
void check_cohort(const CorrespondingCohort& cohort);

/// The corresponding mesh of one shape, in its input's coordinates.
Mesh corresponding_mesh(const CorrespondingCohort& cohort, int shape);

/// A cohort in model coordinates, with its model.
struct AlignedCohort {
  ProcrustesResult alignment;
  std::vector<Mesh> inputs;  ///< the original surfaces, moved by each shape's alignment
  ShapeModel model;
};
/// Procrustes and PCA of all shapes. \pre check_cohort(cohort) passes
AlignedCohort align_cohort(const CorrespondingCohort& cohort, ScaleMode scale,
                           LandmarkWeights weights = LandmarkWeights::equal);

/// The surface moved by a similarity.
Mesh transformed(const Mesh& mesh, const SimilarityTransform& transform);

/// The numbers of modes for which a figure is given: 1 .. 20, then powers of two, and the last. Empty if last
/// < 1.
std::vector<int> mode_counts(int last);

/// A mean with its standard error s / sqrt(n), s with divisor n - 1 (0 for a single value).
struct Estimate {
  double mean = 0;
  double standard_error = 0;
};
/// \pre at least one value
Estimate estimate(const std::vector<double>& values);

/// Three distances of a model's shape to a training shape, mm.
struct ShapeError {
  double hausdorff = 0;     ///< to the original input surface, as SurfaceDistance::hausdorff
  double mean_surface = 0;  ///< to the original input surface, as SurfaceDistance::mean
  double landmark_rms = 0;  ///< ShapeModel::landmark_rms of corresponding landmarks
};

/// ShapeErrors of many shapes or samples at one number of modes.
struct ErrorsAtModes {
  int modes = 0;
  std::vector<ShapeError> items;  ///< one per shape (generalization) or sample (specificity)
  Estimate hausdorff, mean_surface, landmark_rms;
};
/// Fills the estimates from the items.
ErrorsAtModes errors_at_modes(int modes, std::vector<ShapeError> items);

}  // namespace foramen
