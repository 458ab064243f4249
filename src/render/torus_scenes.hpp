#pragma once
/// \file
/// A torus map in pictures: the flat torus and the surface in the same colours.

#include <array>

#include "foramen/parameterize/torus_map.hpp"
#include "render/render_scene.hpp"

namespace foramen {

/// Every place of the torus in its own colour: the torus is laid as a torus of revolution about the grey axis
/// of the colour space OKLab, hue by the first turn, lightness and chroma by the second.
Colour torus_colour(const Vec2& turns);

/// Cells along the two periods, about `count` in all, nearly square in the plane; both numbers are even, so
/// that a checkerboard closes round the torus.
Vec2i checker_cells(const Lattice& lattice, int count);

/// The surface with a checkerboard of the torus: the cells in the colours of their places, every second one
/// lighter. Triangles are cut along the lines of the cells; normals are the vertices', interpolated.
SceneSurface checkered_surface(const Mesh& mesh, const TorusMap& map, const Vec2i& cells);

/// The flat torus cut open along two loops, vertices walked over, which are drawn as its borders: the
/// triangles of the map, in the colours of checkered_surface. Its area is the surface's and its longer period
/// lies across.
Scene torus_map_scene(const Mesh& mesh, const TorusMap& map, const Vec2i& cells,
                      const std::array<std::vector<VertexId>, 2>& loops);

/// Colours of the two loops in every picture.
inline constexpr std::array<Colour, 2> loop_colours{Colour{200, 30, 30}, Colour{20, 90, 200}};

}  // namespace foramen
