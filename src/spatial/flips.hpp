#pragma once
/// \file
/// Flipped triangles of a mesh of corresponding points, relative to its input surface or to the mean shape.

#include <vector>

#include "foramen/spatial/triangle_tree.hpp"

namespace foramen {

/// Triangles of a mesh that are flipped relative to the input surface.
struct SampledFlips {
  /// Faces whose normal opposes that of the input surface at the point closest to the centroid.
  std::vector<FaceId> plain;
  /// Faces of `plain` whose normal also opposes all input triangles within the closest distance plus 0.25
  /// mean edge lengths of the landmark mesh.
  std::vector<FaceId> confirmed;
  std::vector<FaceId> degenerate;  ///< triangles of (nearly) zero area, which have no reliable normal
};

struct SampledFlipsOptions {
  /// Triangles of this height or less count as degenerate, too, because rounding of coordinates may have
  /// flipped them [mm]. >= 0.
  double least_height_mm = 0;
};

/// Two normals oppose each other if their dot product is negative. Input triangles of zero area have no
/// normal and are ignored. A triangle is degenerate if its height is below 1e-12 of its longest side, that
/// is, lost in rounding.
SampledFlips sampled_flips(const Mesh& corresponding, const TriangleTree& input,
                           const SampledFlipsOptions& options = {});

/// The value of least_height_mm for a mesh whose coordinates were rounded to single precision, as in PLY
/// files: eight times the rounding error of the largest coordinate, mm.
double single_precision_height(const Mesh& mesh);

/// Number of triangles of `corresponding` whose normal opposes that of the same triangle of `mean`, after
/// `corresponding` was moved onto `mean` by the least-squares rigid motion \cite umeyama1991. Throws
/// InvalidInput if the triangles of the two meshes differ.
int opposing_mean(const Mesh& corresponding, const Mesh& mean);

/// Number of triangles of `corresponding` that are folded over although they are not folded in `mean`. A
/// triangle is folded over if its normal opposes the sum of the area vectors of the other triangles at its
/// corners. Unlike opposing_mean(), this does not count a part of the surface that has turned as a whole,
/// such as the wall of an osteophyte. Throws InvalidInput if the triangles of the two meshes differ.
int folded_over(const Mesh& corresponding, const Mesh& mean);

}  // namespace foramen
