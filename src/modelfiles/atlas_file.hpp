#pragma once
/// \file
/// The template, the torus map and the transforms of a model, as a file.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "foramen/parameterize/torus_map.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "sampling/remesh.hpp"

namespace foramen {

struct BuiltModel;

/// The template (the input mesh of the reference) with its torus map and loops, the torus positions of the
/// landmarks, and the transform of each shape into model coordinates.
struct Atlas {
  Mesh surface;                                ///< the template, in its input's coordinates, mm
  TorusMap map;                                ///< the template's map
  std::array<std::vector<VertexId>, 2> loops;  ///< vertices along each loop; periods (1,0) and (0,1)
  LandmarkMesh landmarks;
  std::vector<std::string> names;           ///< stems of the shapes
  std::vector<Eigen::Matrix4d> transforms;  ///< one per shape: input coordinates in mm -> model coordinates
};

Atlas atlas_of(const BuiltModel& built);

/// Writes an HDF5 file with these paths. P is the number of landmarks, T of landmark triangles, V and F of
/// the template's vertices and faces:
///
///     /template/points (V,3)          mm
///     /template/triangles (F,3)
///     /template/turns (V,2)
///     /template/jumps (3F,2)          row 3f+k: halfedge 3f+k
///     /lattice (2,2)
///     /loops/0, /loops/1              the template's vertices along each loop
///     /loops/periods (2,2)            one column per loop
///     /landmarks/turns (P,2)
///     /landmarks/triangles (T,3)
///     /landmarks/jumps (3T,2)
///     /shapes/STEM/transform (4,4)
void write_atlas(const std::filesystem::path& path, const Atlas& atlas);

/// Throws IoError or InvalidInput if the file is not such an atlas.
Atlas read_atlas(const std::filesystem::path& path);

}  // namespace foramen
