#pragma once
/// \file
/// Regions of a surface from the segments of a label map.

#include <span>

#include "foramen/core/marks.hpp"
#include "foramen/core/mesh.hpp"
#include "foramen/io/label_map.hpp"
#include "foramen/io/mesh_file.hpp"

namespace foramen {

/// Every vertex is in the region of the voxel that contains it or, if that has no label, of the closest
/// labelled voxel, by the distance to the voxel's centre. A vertex that is more than 3 mm from all of them is
/// in no region. A region's name is that of its segment, or its label if the file names none.
/// \param layers  see read_label_layers()
/// \param surface  mm, in the axes of `space`
RegionsOfShape voxel_regions(std::span<const LabelMap> layers, const Mesh& surface, AnatomicalSpace space);

}  // namespace foramen
