#pragma once
/// \file
/// From torus coordinates to points on a shape: the inverse of a torus map.

#include <cstdint>
#include <span>
#include <vector>

#include "foramen/core/surface_point.hpp"
#include "foramen/parameterize/torus_map.hpp"

namespace foramen {

/// Finds the triangle of a torus map that contains a point. Exact partition: every point has exactly one
/// answer, whatever translate of it is asked for.
///
/// Positions, of the map and of the query, are rounded to multiples of 2^-40 turns (no change for a
/// quantised() map), and sides are decided in integers. A point on an edge or a vertex belongs to the
/// triangle that holds it after an infinitesimal shift by (e, e^2), so exactly one. Buckets over the unit
/// square that hold many triangles are divided again, so that strongly compressed maps stay fast. Const calls
/// may run in parallel.
class TorusLocator {
 public:
  /// Throws InvalidInput if the map has a triangle without positive area after rounding (the message names
  /// the first), or if it covers the torus not once but another number of times.
  TorusLocator(const Mesh& mesh, const TorusMap& map);
  /// \param turns  any representative; within 4096 turns of zero (InvalidInput)
  SurfacePoint locate(const Vec2& turns) const;
  std::vector<SurfacePoint> locate(std::span<const Vec2> turns) const;
  const Mesh& mesh() const { return mesh_; }

 private:
  struct Place {
    std::int64_t x = 0, y = 0;  // multiples of 2^-40 turns
  };
  struct Entry {
    int face;
    std::int16_t x, y;  // whole turns to be added to a query in the unit square
  };
  struct Cell {
    int first = 0, last = 0;  // of entries_
    int grid = -1;            // a finer grid instead of entries
  };
  struct Grid {
    int shift = 0, bits = 0;  // 2^bits x 2^bits cells of width 2^(shift - 40) turns
    int first_cell = 0;
  };
  /// Returns the grid's number, or -1 if dividing wins nothing.
  int build_grid(const std::vector<Entry>& entries, Place corner, int size_bits, int depth);
  std::array<Place, 3> corners(int face) const;

  Mesh mesh_;
  std::vector<Place> places_;  // of each vertex
  // Whole turns to be added to the places of a face's corners, so that its box begins in the unit square.
  std::vector<std::array<std::array<std::int16_t, 2>, 3>> turns_;
  std::vector<Grid> grids_;
  std::vector<Cell> cells_;
  std::vector<Entry> entries_;
};

/// The points of the locator's surface at torus positions.
std::vector<Vec3> lift_to_surface(const TorusLocator& locator, std::span<const Vec2> turns);

}  // namespace foramen
