#pragma once
/// \file
/// Generalized Procrustes alignment of corresponding shapes.

#include <vector>

#include "foramen/core/geometry.hpp"

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

enum class ScaleMode { keep, remove };

/// The least-squares motion (proper rotation; Kabsch, Umeyama) of `moving` onto `fixed`. \param weights per landmark, or empty
SimilarityTransform fit_similarity(std::span<const Vec3> moving, std::span<const Vec3> fixed, ScaleMode scale,
                                   std::span<const double> weights = {});

struct ProcrustesResult {
  std::vector<SimilarityTransform> transforms;   ///< input coordinates -> model coordinates
  std::vector<std::vector<Vec3>> aligned;
  std::vector<Vec3> mean;                        ///< of the aligned shapes, centred at the origin
  int iterations = 0;
  bool converged = false;
};
/// Rotates about until the mean moves by less than 1e-10 of the shapes' size. The first shape fixes the orientation. With ScaleMode::remove the
/// shapes keep their average centroid size.
ProcrustesResult procrustes(const std::vector<std::vector<Vec3>>& shapes, ScaleMode scale, std::span<const double> weights = {});

}  // namespace foramen
