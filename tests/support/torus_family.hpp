#pragma once
/// \file
/// A small cohort that a model can be built of in seconds.

#include <string>

#include "foramen/core/geometry.hpp"
#include "foramen/pipeline/build_model.hpp"
#include "support/lopsided_torus.hpp"

namespace foramen::testing {

inline InputShape shape(const std::string& stem, const TriangleSoup& soup) {
  InputShape input;
  input.stem = stem;
  input.file_name = std::string(stem).append(".ply");
  input.mesh = build_mesh(soup);
  return input;
}

/// One family of shapes, each with its own triangulation, order and pose.
inline Cohort family() {
  Cohort cohort;
  for (int i = 0; i < 4; ++i) {
    InputShape input =
        shape(std::string("s").append(std::to_string(i)),
              renumbered(lopsided_torus_soup(44 + 2 * i, 24, 0.8 + 0.15 * i), static_cast<std::uint64_t>(i)));
    RigidTransform pose = RigidTransform::Identity();
    pose.rotate(Eigen::AngleAxisd(0.9 * i, Vec3(1, 2, -1).normalized())).pretranslate(Vec3(30 * i, -10, 5));
    input.mesh = transformed(input.mesh, pose);
    cohort.shapes.push_back(std::move(input));
  }
  return cohort;
}

inline BuildOptions small() {
  BuildOptions options;
  options.landmarks.count = 1200;
  options.landmarks.spread.grid_points = 12000;
  return options;
}

}  // namespace foramen::testing
