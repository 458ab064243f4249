#pragma once
/// \file
/// Private to extract: smoothing of the steps of a voxel surface.

#include "foramen/extract/extract_label.hpp"

namespace foramen::extract {

struct SmoothedSurface {
  std::vector<Vec3> points;  ///< new positions of the vertices
  int restrained = 0;  ///< number of vertices that were moved back because the surface intersected itself
};

/// Smooths a surface as described at extract_label().
/// \param start  a surface without self-intersections, mm along the axes of the lattice
/// \param volume  volume that the result encloses, mm^3
/// \param bound  bound of displacements, voxels
SmoothedSurface smooth_surface(const TriangleSoup& start, const Vec3& spacing, double volume, int rounds,
                               double bound);

}  // namespace foramen::extract
