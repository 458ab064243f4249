#pragma once
/// \file
/// Private to io: the cells of VTK's unstructured grids.

#include <cstdint>
#include <span>

#include "io/soup_builder.hpp"

namespace foramen::io_detail {

/// Adds cell number `index`, of a type by VTK's numbers, if it is a face of a surface. Points and lines are
/// passed over. Throws IoError that names the kind of any other cell, e.g. tetrahedra.
void add_vtk_cell(SoupBuilder& soup, const Source& source, std::int64_t type,
                  std::span<const std::int64_t> corners, std::size_t index);

}  // namespace foramen::io_detail
