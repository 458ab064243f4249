#pragma once
/// \file
/// Private to extract: the surface between the voxels that are inside and those that are not.

#include "extract/binary_volume.hpp"

namespace foramen::extract {

/// Marching cubes on the lattice of voxel centres: one vertex in the middle between every two neighbours
/// (across a face) of which one is inside, so on the face between them; triangles by cube_triangles().
/// Closed, manifold and wound outward for any voxels; one surface for each pair of an inside and an outside
/// component that meet. Points in voxel coordinates: the centre of voxel (i, j, k) is (i, j, k). \pre no
/// inside voxel in the outermost layer. Throws InvalidInput beyond 20 million vertices.
TriangleSoup voxel_surface(const BinaryVolume& volume, EdgeContact contact);

/// The faces between inside and outside voxels, two triangles each with vertices of their own, since at an
/// edge four of them may meet. In voxel coordinates.
TriangleSoup voxel_boundary(const BinaryVolume& volume);

}  // namespace foramen::extract
