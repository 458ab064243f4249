#include "io/vtk_cells.hpp"

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace foramen::io_detail {
namespace {

// The types that are read.
enum CellType : std::int64_t {
  empty_cell = 0,
  vertex = 1,
  poly_vertex = 2,
  line = 3,
  poly_line = 4,
  triangle = 5,
  triangle_strip = 6,
  polygon = 7,
  pixel = 8,  // a quad whose last two corners are swapped
  quad = 9
};

std::string name_of(std::int64_t type) {
  constexpr std::array<std::string_view, 7> volumes{
      "tetrahedra", "voxels", "hexahedra", "wedges", "pyramids", "pentagonal prisms", "hexagonal prisms"};
  constexpr std::int64_t first_volume = 10;
  if (type >= first_volume && type < first_volume + std::ssize(volumes))
    return std::string(volumes[type - first_volume]);
  return "cells of type " + std::to_string(type);
}

}  // namespace

void add_vtk_cell(SoupBuilder& soup, const Source& source, std::int64_t type,
                  std::span<const std::int64_t> corners, std::size_t index) {
  const auto place = [&] { return "cell " + std::to_string(index); };
  switch (type) {
    case empty_cell:
      return;
    case vertex:
    case poly_vertex:
    case line:
    case poly_line:
      return soup.pass_over_loose(1);
    case triangle:
    case polygon:
    case quad:
      return soup.add_face(corners, soup.points(), place);
    case pixel: {
      std::vector<std::int64_t> around(corners.begin(), corners.end());
      if (around.size() == 4) std::swap(around[2], around[3]);
      return soup.add_face(around, soup.points(), place);
    }
    case triangle_strip:
      return soup.add_strip(corners, soup.points(), place);
    default:
      source.refuse("holds " + name_of(type) + ", not only the faces of a surface",
                    "take the surface out of the grid (ParaView: Extract Surface) and save it as PLY");
  }
}

}  // namespace foramen::io_detail
