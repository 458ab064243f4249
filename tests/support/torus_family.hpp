#pragma once
/// \file
/// A small cohort whose model can be built in seconds.

#include <string>
#include <vector>

#include "foramen/core/geometry.hpp"
#include "foramen/stages/build_model.hpp"
#include "support/lopsided_torus.hpp"

namespace foramen::testing {

/// One family of shapes, each with its own triangulation, order and pose: s0 to s3.
inline std::vector<Shape> family() {
  std::vector<Shape> shapes;
  for (int i = 0; i < 4; ++i) {
    const Mesh mesh = build_mesh(
        renumbered(lopsided_torus_soup(44 + 2 * i, 24, 0.8 + 0.15 * i), static_cast<std::uint64_t>(i)));
    RigidTransform pose = RigidTransform::Identity();
    pose.rotate(Eigen::AngleAxisd(0.9 * i, Vec3(1, 2, -1).normalized())).pretranslate(Vec3(30 * i, -10, 5));
    shapes.push_back({std::string("s").append(std::to_string(i)), transformed(mesh, pose)});
  }
  return shapes;
}

inline BuildOptions small() {
  BuildOptions options;
  options.landmarks.count = 1200;
  options.landmarks.spread.grid_points = 12000;
  return options;
}

}  // namespace foramen::testing
