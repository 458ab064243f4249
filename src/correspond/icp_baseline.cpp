#include "correspond/icp_baseline.hpp"

#include <string>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

void check(std::size_t landmarks, std::size_t normals, const Mesh& shape,
           const IcpCorrespondenceOptions& options) {
  if (landmarks != normals)
    throw InvalidInput("icp_correspondence: " + std::to_string(landmarks) + " landmarks but " +
                       std::to_string(normals) + " normals; give one normal per landmark");
  if (shape.face_count() == 0) throw InvalidInput("icp_correspondence: the shape has no triangle");
  if (!(options.min_normal_cosine >= -1 && options.min_normal_cosine < 1))
    throw InvalidInput("icp_correspondence: min_normal_cosine is " +
                       std::to_string(options.min_normal_cosine) + "; it must be in [-1, 1)");
  if (!(options.search_cap > 0))
    throw InvalidInput("icp_correspondence: search_cap is " + std::to_string(options.search_cap) +
                       "; it must be > 0 mm");
}

}  // namespace

IcpCorrespondence icp_correspondence(std::span<const Vec3> landmarks, std::span<const Vec3> landmark_normals,
                                     const TriangleTree& shape, const RigidTransform& shape_to_reference,
                                     const IcpCorrespondenceOptions& options) {
  check(landmarks.size(), landmark_normals.size(), shape.mesh(), options);
  const RigidTransform reference_to_shape = shape_to_reference.inverse();
  IcpCorrespondence result;
  result.points.reserve(landmarks.size());
  result.on.reserve(landmarks.size());
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const Vec3 place = reference_to_shape * landmarks[i];
    const Vec3 normal = reference_to_shape.linear() * landmark_normals[i];
    std::optional<ClosestPoint> found =
        shape.closest_compatible(place, normal, options.min_normal_cosine, options.search_cap);
    if (!found) {
      ++result.without_compatible;
      found = shape.closest(place);
    }
    FORAMEN_ASSERT(found->on.face.valid());
    result.points.push_back(found->point);
    result.on.push_back(found->on);
  }
  return result;
}

}  // namespace foramen
