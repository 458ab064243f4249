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
  Eigen::Matrix4d matrix() const;
};

/// Whether size is a part of shape.
enum class ScaleMode { keep, remove };
template <>
struct EnumWords<ScaleMode> {
  static constexpr std::pair<std::string_view, ScaleMode> all[] = {{"keep", ScaleMode::keep},
                                                                   {"remove", ScaleMode::remove}};
};

/// The least-squares motion of `moving` onto `fixed`, min sum_i w_i |s R m_i + t - f_i|^2 over proper
/// rotations R (a reflection is never chosen), and over s > 0 with ScaleMode::remove. \cite kabsch1976 \cite
/// umeyama1991 \param weights  per landmark, >= 0, or empty
SimilarityTransform fit_similarity(std::span<const Vec3> moving, std::span<const Vec3> fixed, ScaleMode scale,
                                   std::span<const double> weights = {});

struct ProcrustesResult {
  std::vector<SimilarityTransform> transforms;  ///< input coordinates -> model coordinates
  std::vector<std::vector<Vec3>> aligned;
  std::vector<Vec3> mean;  ///< of the aligned shapes, its (weighted) centroid at the origin
  int iterations = 0;
  bool converged = false;
};
/// Generalized Procrustes alignment \cite gower1975 by proper rotations, until the mean moves by less than
/// 1e-10 of its size; centroids, sizes and least squares count landmark i w_i times. The first shape fixes
/// the orientation: its own rotation is the identity. With ScaleMode::remove every shape gets the same
/// centroid size, the average of the input's. Deterministic; invariant under rigid motion of any shape but
/// the first. Throws InvalidInput (no shapes, different numbers of landmarks, a shape without size, weights
/// that are not >= 0).
ProcrustesResult procrustes(const std::vector<std::vector<Vec3>>& shapes, ScaleMode scale,
                            std::span<const double> weights = {});

/// Where a shape that is not in the cohort belongs: least-squares motion onto the cohort's mean; with
/// ScaleMode::remove scaled to the cohort's centroid size, as procrustes() scales its own shapes.
SimilarityTransform align_to_mean(std::span<const Vec3> shape, const ProcrustesResult& cohort,
                                  ScaleMode scale, std::span<const double> weights = {});

}  // namespace foramen
