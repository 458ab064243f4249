#pragma once
/// \file
/// Generalized Procrustes alignment of corresponding shapes.

#include <span>
#include <vector>

#include "foramen/core/geometry.hpp"
#include "foramen/core/options.hpp"

namespace foramen {

/// x -> scale * rotation x + translation.
struct SimilarityTransform {
  double scale = 1;
  Mat3 rotation = Mat3::Identity();
  Vec3 translation = Vec3::Zero();
  Vec3 operator()(const Vec3& p) const { return scale * (rotation * p) + translation; }
  SimilarityTransform inverse() const;
  /// The transform as a homogeneous 4 x 4 matrix.
  Eigen::Matrix4d matrix() const;
};

/// Whether the size of a shape is kept as part of its variation or removed by scaling.
enum class ScaleMode { keep, remove };
template <>
struct EnumWords<ScaleMode> {
  static constexpr std::pair<std::string_view, ScaleMode> all[] = {{"keep", ScaleMode::keep},
                                                                   {"remove", ScaleMode::remove}};
};

/// The least-squares similarity transform of `moving` onto `fixed`: it minimises sum_i w_i |s R m_i + t -
/// f_i|^2 over translations t and proper rotations R (never a reflection), and with ScaleMode::remove also
/// over s > 0; with ScaleMode::keep s = 1. \cite kabsch1976 \cite umeyama1991
/// \param weights  one per landmark, >= 0, or empty for equal weights
SimilarityTransform fit_similarity(std::span<const Vec3> moving, std::span<const Vec3> fixed, ScaleMode scale,
                                   std::span<const double> weights = {});

/// The result of procrustes().
struct ProcrustesResult {
  std::vector<SimilarityTransform> transforms;  ///< input coordinates -> model coordinates
  std::vector<std::vector<Vec3>> aligned;
  std::vector<Vec3> mean;  ///< mean of the aligned shapes, mm; its (weighted) centroid is the origin
  int iterations = 0;
  bool converged = false;
};
/// Generalized Procrustes alignment \cite gower1975 by proper rotations. It iterates until the RMS change of
/// the mean is below 1e-10 of the size of the mean, for at most 1000 iterations (`converged` is false then).
/// Centroids, centroid sizes and least squares are weighted by w_i. The rotation of the first shape is the
/// identity, which fixes the orientation of the model. With ScaleMode::remove all shapes are scaled to the
/// same centroid size, the average over the input shapes. The result is deterministic and, up to rounding,
/// invariant under rigid motions of all shapes but the first. Throws InvalidInput if there are no shapes,
/// numbers of landmarks differ, a shape has no size, or a weight is not >= 0.
ProcrustesResult procrustes(const std::vector<std::vector<Vec3>>& shapes, ScaleMode scale,
                            std::span<const double> weights = {});

/// Aligns a shape that is not in the cohort: the least-squares rigid motion onto the mean of the cohort. With
/// ScaleMode::remove the shape is scaled to the centroid size of the aligned cohort, as procrustes() does
/// with its own shapes.
SimilarityTransform align_to_mean(std::span<const Vec3> shape, const ProcrustesResult& cohort,
                                  ScaleMode scale, std::span<const double> weights = {});

}  // namespace foramen
