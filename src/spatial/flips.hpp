#pragma once
/// \file
/// Flipped triangles of a corresponding mesh against its input surface.

#include <vector>

#include "foramen/spatial/triangle_tree.hpp"

namespace foramen {

struct SampledFlips {
  std::vector<FaceId> plain;  ///< normal opposes the input's at the closest point of the centroid
  std::vector<FaceId>
      confirmed;  ///< ... and opposes every input triangle within closest distance + 0.25 mean landmark edge
  std::vector<FaceId> degenerate;  ///< without area (a normal cannot be given)
};

struct SampledFlipsOptions {
  /// Triangles of this height or less count as degenerate too [mm]: what rounding may have turned over. >= 0.
  double least_height_mm = 0;
};

/// Two normals oppose each other when their dot product is negative. Input triangles without area have no
/// normal and are passed over. A triangle counts as degenerate when its height is lost in rounding: below
/// 1e-12 of its longest side.
SampledFlips sampled_flips(const Mesh& corresponding, const TriangleTree& input,
                           const SampledFlipsOptions& options = {});

/// The least height for a mesh whose coordinates have been rounded to single precision, as PLY files hold
/// them: eight times the rounding error of its largest coordinate.
double single_precision_height(const Mesh& mesh);

/// Triangles of `corresponding` whose normal opposes that of the same triangle of `mean`, after
/// `corresponding` was moved onto `mean` by the least-squares rigid motion (Umeyama 1991, \cite umeyama1991).
/// Throws InvalidInput if the two differ in their triangles.
int opposing_mean(const Mesh& corresponding, const Mesh& mean);

/// Triangles of `corresponding` that are folded over: their normal opposes the sum, over their corners, of
/// the area vectors of the other triangles around the corner, where in `mean` it does not. Unlike
/// opposing_mean() it does not count a part of the surface that has turned as a whole, such as the wall of an
/// outgrowth. Throws InvalidInput if the two differ in their triangles.
int folded_over(const Mesh& corresponding, const Mesh& mean);

}  // namespace foramen
