#pragma once
/// \file
/// Distance of two surfaces as docs/evaluation.md defines it.

#include <cstdint>
#include <vector>

#include "foramen/core/rng.hpp"
#include "foramen/spatial/triangle_tree.hpp"

namespace foramen {

/// `count` points spread over the surface, stratified by area (one per equal share of the area, in face
/// order). Throws InvalidInput if the surface has no area or `count` is negative.
std::vector<SurfacePoint> sample_surface(const Mesh& mesh, int count, const Rng& rng);

struct SurfaceDistanceOptions {
  int samples = 20000;  ///< a side, > 0
  std::uint64_t seed = 1;
};

struct SurfaceDistance {
  double mean = 0;  ///< average of the two one-sided means over samples, mm
  double p95 = 0;   ///< 95th percentile of both sample sets together (the smallest distance that 95 % do not
                    ///< exceed), mm
  double hausdorff = 0;  ///< largest over samples and all vertices of both, mm; a lower bound of the true one
};

/// Exact point-to-triangle distances, both ways. Symmetric in its arguments.
SurfaceDistance surface_distance(const TriangleTree& a, const TriangleTree& b,
                                 const SurfaceDistanceOptions& options = {});

/// The same for samples drawn before (by sample_surface), when many surfaces are compared with one.
SurfaceDistance surface_distance(const TriangleTree& a, std::span<const SurfacePoint> samples_of_a,
                                 const TriangleTree& b, std::span<const SurfacePoint> samples_of_b);

}  // namespace foramen
