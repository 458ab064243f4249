#pragma once

#include <Eigen/Geometry>

#include "render/render_scene.hpp"

namespace foramen::testing {

/// Where a point is in the picture, right and up of its centre, in mm.
inline Vec2 in_picture(const Camera& camera, const Vec3& p) {
  return {camera.direction.cross(camera.up).dot(p - camera.centre), camera.up.dot(p - camera.centre)};
}

}  // namespace foramen::testing
