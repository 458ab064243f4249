#pragma once
/// \file
/// Private to extract: the surface between inside and outside voxels.

#include "extract/binary_volume.hpp"

namespace foramen::extract {

/// Marching cubes on the lattice of voxel centres. Each voxel face between an inside and an outside voxel has
/// one vertex at its centre; the triangles come from cube_triangles(). The result is closed, manifold and
/// wound outward for any voxels, with one surface for each pair of an inside and an outside component that
/// touch. Points are in voxel coordinates: the centre of voxel (i, j, k) is (i, j, k). Throws InvalidInput
/// beyond 20 million vertices. \pre no inside voxel in the outermost layer
TriangleSoup voxel_surface(const BinaryVolume& volume, EdgeContact contact);

/// The faces between inside and outside voxels as two triangles each, in voxel coordinates. Faces do not
/// share vertices, because four faces may meet at an edge.
TriangleSoup voxel_boundary(const BinaryVolume& volume);

}  // namespace foramen::extract
