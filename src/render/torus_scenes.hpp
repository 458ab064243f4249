#pragma once
/// \file
/// A torus map in pictures: the flat torus and the surface in the same colours.

#include <array>

#include "foramen/parameterize/torus_map.hpp"
#include "render/render_scene.hpp"

namespace foramen {

/// The colour of a place of the torus; no two places have the same colour. The torus is mapped to a torus of
/// revolution about the grey axis of the colour space OKLab: the first turn determines the hue, the second
/// the lightness and chroma.
Colour torus_colour(const Vec2& turns);

/// The numbers of cells along the two periods, for about `count` cells in all, which are nearly square in the
/// plane. Both numbers are even, so that a checkerboard has no seam.
Vec2i checker_cells(const Lattice& lattice, int count);

/// The surface with a checkerboard of the torus. Each cell has the colour of its place, and every second cell
/// is lighter. Triangles are cut along the borders of the cells; normals are interpolated from those of the
/// vertices.
SceneSurface checkered_surface(const Mesh& mesh, const TorusMap& map, const Vec2i& cells);

/// The flat torus, cut open along two loops, which are drawn as its borders. A loop is given by its vertices.
/// The picture shows the triangles of the map in the colours of checkered_surface(). Its area is that of the
/// surface, and its longer period is horizontal.
Scene torus_map_scene(const Mesh& mesh, const TorusMap& map, const Vec2i& cells,
                      const std::array<std::vector<VertexId>, 2>& loops);

/// The colours of the two loops in all pictures.
inline constexpr std::array<Colour, 2> loop_colours{Colour{200, 30, 30}, Colour{20, 90, 200}};

}  // namespace foramen
