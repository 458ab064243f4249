#pragma once
/// \file
/// Topology and quality audit of a triangle soup. Never throws on bad geometry: it reports it.

#include <optional>
#include <string>
#include <vector>

#include "foramen/core/geometry.hpp"
#include "foramen/core/mesh.hpp"
#include "foramen/core/remedy.hpp"

namespace foramen {

struct MeshReport {
  int vertices = 0, triangles = 0, edges = 0;
  int unused_vertices = 0;    ///< belong to no triangle
  int invalid_triangles = 0;  ///< index out of range or a corner used twice
  int non_finite_vertices = 0;
  int components = 0;             ///< of triangles joined by edges or vertices
  int boundary_edges = 0;         ///< edges with one triangle; 0 = closed
  int non_manifold_edges = 0;     ///< edges with three or more triangles
  int non_manifold_vertices = 0;  ///< triangles do not form one fan
  int misoriented_edges = 0;      ///< two triangles run along the edge in the same direction
  int degenerate_triangles =
      0;  ///< area no more than 1e-12 of the squared bounding-box diagonal, or a repeated corner
  int duplicate_triangles = 0;  ///< the same three corners as an earlier one
  int duplicate_vertices = 0;   ///< exactly the coordinates of an earlier one
  int euler_number = 0;         ///< V - E + F of the used vertices
  std::optional<int> genus;     ///< only for one closed, manifold, oriented component: (2 - euler) / 2
  double area = 0;              ///< in squared file units
  double volume = 0;            ///< signed; meaningful when closed
  bool inward = false;          ///< closed and wound inward (negative volume)
  BoundingBox box{Vec3::Zero(), Vec3::Zero()};
  double mean_edge = 0;

  bool closed() const { return boundary_edges == 0 && triangles > 0; }
  bool manifold() const { return non_manifold_edges == 0 && non_manifold_vertices == 0; }
  bool oriented() const { return misoriented_edges == 0; }
};

MeshReport inspect_mesh(const TriangleSoup& soup);

/// A triangle of this area or less is degenerate on a surface whose bounding box has this diagonal.
double degenerate_area(double diagonal);

/// Why this surface cannot be used for a model, and what to do about it; empty if it can (one closed,
/// manifold, oriented genus-1 surface of finite, valid elements; inward winding is not an obstacle).
struct Obstacle {
  std::string finding;  ///< e.g. "genus 3"
  std::string advice;   ///< e.g. "repair the surface, which keeps the largest piece, or delete islands ..."
  std::vector<Remedy> remedies = {};
  Message message() const { return {finding + "; " + advice, remedies}; }
};
std::optional<Obstacle> obstacle_to_model(const MeshReport& report);

}  // namespace foramen
