#pragma once
/// \file
/// Robust matches between a template and a shape, sought from both surfaces.

#include <optional>
#include <vector>

#include "match/oriented_points.hpp"
#include "match/vertex_matches.hpp"

namespace foramen {

/// All matches of one template vertex combined to \f$ (x - target)^T W (x - target) \f$ of its position x.
struct VertexPull {
  int vertex = -1;
  Mat3 weight = Mat3::Zero();  ///< W, mm^-2
  Vec3 weighted_shift =
      Vec3::Zero();  ///< W (target - origin), from the position of the vertex before it was bent
};

/// Matches points of each surface with the nearest points of the other by position and normal. Tukey's
/// biweight removes points without partner.
class TwoWayMatches {
 public:
  /// \param surface  the template before it is bent
  /// \param shape  aligned to the template
  TwoWayMatches(const Mesh& surface, const Mesh& shape, const MatchOptions& options);

  /// The pulls on the bent template, for a standard deviation of each independent match in the direction of
  /// the normals.
  std::vector<VertexPull> pulls(const Mesh& bent, double noise_mm) const;

 private:
  const Mesh& surface_;
  MatchOptions options_;
  std::vector<double> template_curvedness_;  // empty if no curvature is used
  std::optional<IndexedPoints> shape_vertices_;
  std::vector<OrientedPoint> shape_samples_;
  std::vector<int> vertices_;  // of the template, stratified by area
  double area_per_sample_, area_per_vertex_;
};

}  // namespace foramen
