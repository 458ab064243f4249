#pragma once
/// \file
/// The template, the torus map and the transforms of a model, as a file.

#include <filesystem>

#include "modelfiles/atlas.hpp"

namespace foramen {

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
///     /landmarks/curvatures (P,2)     absent if there are none
///     /shapes/STEM/transform (4,4)
void write_atlas(const std::filesystem::path& path, const Atlas& atlas);

/// Throws IoError or InvalidInput if the file is not such an atlas.
Atlas read_atlas(const std::filesystem::path& path);

}  // namespace foramen
