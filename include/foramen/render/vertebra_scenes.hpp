#pragma once
/// \file
/// The standard views of a vertebra, and scenes of loops, torus maps, modes and flips.

#include <span>
#include <vector>

#include "foramen/render/render_scene.hpp"

namespace foramen {

/// From which side a surface is looked at, in its own principal frame (the canal's axis is not known to it):
/// along the shortest, middle or longest principal axis.
enum class View { along_shortest, along_middle, along_longest };

/// Camera of that view of these points; the same for all scenes made with the same points.
void look(Scene& scene, std::span<const Vec3> points, View view);

/// The flat torus, cut at turns 0, as a square of coloured triangles: each triangle of the map in the colour
/// of its vertices' place on the surface.
Scene torus_map_scene(const TriangleSoup& surface, std::span<const Vec2> turns, std::span<const Vec2i> jumps,
                      const Mat2& lattice);

/// A checkerboard in torus coordinates: what correspondence looks like on a surface.
std::vector<Colour> checkerboard(std::span<const Vec2> turns, int squares);

/// A surface with some triangles marked red.
SceneSurface marked_surface(const TriangleSoup& surface, const std::vector<int>& marked);

}  // namespace foramen
