#pragma once
/// \file
/// What a model was made from, as a file.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "foramen/parameterize/torus_map.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "sampling/remesh.hpp"

namespace foramen {

struct BuiltModel;

/// The template (the reference's input mesh) with its torus map and loops, the landmarks' coordinates, each
/// shape's way into model coordinates.
struct Atlas {
  Mesh surface;                                ///< the template, in its input's coordinates, mm
  TorusMap map;                                ///< of it
  std::array<std::vector<VertexId>, 2> loops;  ///< vertices walked over; periods (1,0) and (0,1)
  LandmarkMesh landmarks;
  std::vector<std::string> names;           ///< stems of the shapes
  std::vector<Eigen::Matrix4d> transforms;  ///< one per shape: input coordinates in mm -> model coordinates
};

Atlas atlas_of(const BuiltModel& built);

/// HDF5 with these paths; P landmarks, T landmark triangles, V and F of the template:
///
///     /template/points (V,3) mm     /template/triangles (F,3)     /template/turns (V,2)     /template/jumps
///     (3F,2), halfedge 3f+k /lattice (2,2)                /loops/0, /loops/1: template vertices walked over
///     /loops/periods (2,2), a column a loop /landmarks/turns (P,2)        /landmarks/triangles (T,3)
///     /landmarks/jumps (3T,2) /shapes/STEM/transform (4,4)
void write_atlas(const std::filesystem::path& path, const Atlas& atlas);

/// Throws IoError or InvalidInput if the file is not such an atlas.
Atlas read_atlas(const std::filesystem::path& path);

}  // namespace foramen
