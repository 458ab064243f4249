#pragma once
/// \file
/// What a finished model keeps of its correspondence.

#include <array>
#include <string>
#include <vector>

#include "foramen/parameterize/torus_map.hpp"
#include "foramen/sampling/landmark_mesh.hpp"

namespace foramen {

struct BuiltModel;

/// The template (the input mesh of the reference) with its torus map and loops, the torus positions of the
/// landmarks, and the transform of each shape into model coordinates.
struct Atlas {
  Mesh surface;                                ///< the template, in its input's coordinates, mm
  TorusMap map;                                ///< the template's map
  std::array<std::vector<VertexId>, 2> loops;  ///< vertices along each loop; periods (1,0) and (0,1)
  LandmarkMesh landmarks;
  /// TemplateSurface::curvatures of the last round's template at each landmark; empty without such rounds.
  std::vector<Vec2> curvatures;
  std::vector<std::string> names;           ///< stems of the shapes
  std::vector<Eigen::Matrix4d> transforms;  ///< one per shape: input coordinates in mm -> model coordinates
};

Atlas atlas_of(const BuiltModel& built);

}  // namespace foramen
