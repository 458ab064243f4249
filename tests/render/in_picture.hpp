#pragma once

#include <Eigen/Geometry>

#include "render/render_scene.hpp"

namespace foramen::testing {

/// The place of a point in the picture, in mm to the right of and above its centre.
inline Vec2 in_picture(const Camera& camera, const Vec3& p) {
  return {camera.direction.cross(camera.up).dot(p - camera.centre), camera.up.dot(p - camera.centre)};
}

}  // namespace foramen::testing
