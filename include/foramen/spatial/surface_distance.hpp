#pragma once
/// \file
/// Distances between two surfaces, as defined in docs/evaluation.md.

#include <cstdint>
#include <vector>

#include "foramen/core/rng.hpp"
#include "foramen/spatial/triangle_tree.hpp"

namespace foramen {

/// Draws `count` random points on the surface, stratified by area: the surface is divided into `count` parts
/// of equal area in face order, with one point in each. Throws InvalidInput if the surface has no area or
/// `count` is negative.
std::vector<SurfacePoint> sample_surface(const Mesh& mesh, int count, const Rng& rng);

struct SurfaceDistanceOptions {
  int samples = 20000;  ///< samples per surface, > 0
  std::uint64_t seed = 1;
};

/// Symmetric distances between two surfaces.
struct SurfaceDistance {
  double mean = 0;  ///< average of the two one-sided mean distances of samples, mm
  double p95 = 0;   ///< 95th percentile of the distances of both sample sets together, mm
  /// Largest distance of samples and vertices of both surfaces, mm; a lower bound of the Hausdorff distance.
  double hausdorff = 0;
};

/// Distances between samples of each surface and the other surface, by exact point-to-triangle distances.
/// Symmetric in its arguments.
SurfaceDistance surface_distance(const TriangleTree& a, const TriangleTree& b,
                                 const SurfaceDistanceOptions& options = {});

/// The same for samples that sample_surface() has drawn before, for comparing one surface with many.
SurfaceDistance surface_distance(const TriangleTree& a, std::span<const SurfacePoint> samples_of_a,
                                 const TriangleTree& b, std::span<const SurfacePoint> samples_of_b);

}  // namespace foramen
