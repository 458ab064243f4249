#pragma once
/// \file
/// From torus coordinates to points on a shape: the inverse of a torus map.

#include <cstdint>
#include <span>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/parameterize/torus_map.hpp"

namespace foramen {

/// Finds the triangle of a torus map that contains a point. The decision is exact: every point of the torus
/// belongs to exactly one triangle, and all its lattice translates give the same one.
///
/// Positions of the map and of queries are rounded to multiples of 2^-40 turns (no change for a quantised()
/// map), and orientation tests are done in integers. A point on an edge or a vertex belongs to the triangle
/// that contains it after an infinitesimal shift by (e, e^2). The search uses a grid over the unit square
/// whose crowded cells are subdivided, so queries are fast for strongly compressed maps, too. Const members
/// may be called from many threads at once.
class TorusLocator {
 public:
  /// Throws InvalidInput if a triangle of the map has no positive area after rounding (the message names the
  /// first), or if the map does not cover the torus exactly once.
  TorusLocator(const Mesh& mesh, const TorusMap& map);
  /// \param turns  any representative of the position; InvalidInput beyond +-4096 turns
  SurfacePoint locate(const Vec2& turns) const;
  std::vector<SurfacePoint> locate(std::span<const Vec2> turns) const;
  const Mesh& mesh() const { return mesh_; }

 private:
  struct Place {
    std::int64_t x = 0, y = 0;  // multiples of 2^-40 turns
  };
  struct Entry {
    int face;
    std::int16_t x, y;  // whole turns to add to a query in the unit square
  };
  struct Cell {
    int first = 0, last = 0;  // range in entries_
    int grid = -1;            // index of a finer grid that replaces the entries; -1: none
  };
  struct Grid {
    int shift = 0, bits = 0;  // 2^bits x 2^bits cells of width 2^(shift - 40) turns
    int first_cell = 0;
  };
  /// Returns the index of the new grid, or -1 if a subdivision would not help.
  int build_grid(const std::vector<Entry>& entries, Place corner, int size_bits, int depth);
  std::array<Place, 3> corners(int face) const;

  Mesh mesh_;
  std::vector<Place> places_;  // position of each vertex
  // Whole turns to add to the corners of each face, so that the lower corner of its bounding box is in the
  // unit square.
  std::vector<std::array<std::array<std::int16_t, 2>, 3>> turns_;
  std::vector<Grid> grids_;
  std::vector<Cell> cells_;
  std::vector<Entry> entries_;
};

/// The points on the surface of the locator at these torus positions.
std::vector<Vec3> lift_to_surface(const TorusLocator& locator, std::span<const Vec2> turns);

}  // namespace foramen
