#pragma once
/// \file
/// The baseline the paper compares with: correspondence by closest points after rigid alignment.

#include <limits>
#include <span>
#include <vector>

#include "foramen/core/geometry.hpp"
#include "foramen/spatial/triangle_tree.hpp"

namespace foramen {

struct IcpCorrespondenceOptions {
  /// A face is compatible when n . landmark normal > this. In [-1, 1). 45 degrees: of 90, 60, 45 the best for
  /// the baseline in truth error, representation and generalization.
  double min_normal_cosine = 0.7;
  double search_cap =
      std::numeric_limits<double>::infinity();  ///< Compatible points are sought closer than this [mm]. > 0.
};

struct IcpCorrespondence {
  std::vector<Vec3> points;      ///< one per landmark, in the SHAPE's own coordinates, mm
  std::vector<SurfacePoint> on;  ///< the same places on the shape's mesh
  int without_compatible = 0;    ///< landmarks that had no compatible point and took the plain closest one
};

/// Every landmark goes to the closest surface point of the shape whose normal is compatible with the
/// landmark's own (Brett and Taylor 2000, \cite brett2000). Several landmarks may share a point and triangles
/// may turn over: that is the baseline. \param landmarks, landmark_normals  in reference coordinates \param
/// shape_to_reference  as align(shape, reference) gives it Throws InvalidInput if points and normals differ
/// in number, an option is out of range or the shape has no triangle.
IcpCorrespondence icp_correspondence(std::span<const Vec3> landmarks, std::span<const Vec3> landmark_normals,
                                     const TriangleTree& shape, const RigidTransform& shape_to_reference,
                                     const IcpCorrespondenceOptions& options = {});

}  // namespace foramen
