#pragma once
/// \file
/// Private to extract: smoothing of the steps of a voxel surface.

#include "foramen/extract/extract_label.hpp"

namespace foramen::extract {

struct SmoothedSurface {
  std::vector<Vec3> points;  ///< new positions of the vertices
  int restrained = 0;  ///< number of vertices that were moved back because the surface intersected itself
};

/// As extract_label() says. \param start  without self-intersections, mm along the lattice's axes.
/// \param volume  to be enclosed in the end, mm^3; of no effect without rounds. \param bound  in voxels
SmoothedSurface smooth_surface(const TriangleSoup& start, const Vec3& spacing, double volume, int rounds,
                               double bound);

}  // namespace foramen::extract
