#pragma once
/// \file
/// The baseline of the paper: correspondence by closest points after rigid alignment.

#include <limits>
#include <span>
#include <vector>

#include "foramen/core/geometry.hpp"
#include "foramen/spatial/triangle_tree.hpp"

namespace foramen {

struct IcpCorrespondenceOptions {
  /// A face is compatible if the cosine between its normal and that of the landmark is above this. In [-1,
  /// 1). The default, 45 degrees, gives the baseline the best truth error, representation and generalization
  /// of 90, 60 and 45 degrees.
  double min_normal_cosine = 0.7;
  /// Only compatible points closer than this are accepted [mm]. > 0.
  double search_cap = std::numeric_limits<double>::infinity();
};

struct IcpCorrespondence {
  std::vector<Vec3> points;      ///< one per landmark, in the coordinates of the shape, mm
  std::vector<SurfacePoint> on;  ///< the same points on the mesh of the shape
  int without_compatible = 0;  ///< landmarks without compatible point, which were moved to the closest point
};

/// Moves every landmark to the closest surface point of the shape whose normal is compatible with that of the
/// landmark \cite brett2000. This does not prevent several landmarks from sharing a point or triangles from
/// being flipped. Throws InvalidInput if the numbers of points and normals differ, an option is out of range
/// or the shape has no triangle.
/// \param landmarks  positions in reference coordinates, mm
/// \param landmark_normals  their unit normals in reference coordinates
/// \param shape_to_reference  the result of align(shape, reference)
IcpCorrespondence icp_correspondence(std::span<const Vec3> landmarks, std::span<const Vec3> landmark_normals,
                                     const TriangleTree& shape, const RigidTransform& shape_to_reference,
                                     const IcpCorrespondenceOptions& options = {});

}  // namespace foramen
