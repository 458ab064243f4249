#pragma once
/// \file
/// Topology and quality report on a triangle soup. Defects of the geometry are reported, never thrown.

#include <optional>
#include <string>
#include <vector>

#include "foramen/core/geometry.hpp"
#include "foramen/core/mesh.hpp"
#include "foramen/core/remedy.hpp"

namespace foramen {

/// The topology and the defects of a triangle soup.
struct MeshReport {
  int vertices = 0, triangles = 0, edges = 0;
  int unused_vertices = 0;    ///< vertices that belong to no triangle
  int invalid_triangles = 0;  ///< triangles with an index out of range or a repeated corner
  int non_finite_vertices = 0;
  int components = 0;             ///< connected components of triangles that share vertices
  int boundary_edges = 0;         ///< edges with one triangle; 0 for a closed surface
  int non_manifold_edges = 0;     ///< edges with three or more triangles
  int non_manifold_vertices = 0;  ///< vertices whose triangles do not form one fan
  int misoriented_edges = 0;      ///< edges along which two triangles run in the same direction
  int degenerate_triangles =
      0;  ///< area no more than 1e-12 of the squared bounding-box diagonal, or a repeated corner
  int duplicate_triangles = 0;  ///< triangles with the same three corners as an earlier one
  int duplicate_vertices = 0;   ///< vertices with exactly the coordinates of an earlier one
  int euler_number = 0;         ///< V - E + F of the used vertices
  std::optional<int> genus;     ///< only for one closed, manifold, oriented component: (2 - euler) / 2
  double area = 0;              ///< in squared units of the file
  double volume = 0;            ///< signed; meaningful for a closed surface only
  bool inward = false;          ///< closed and wound inward (negative volume)
  BoundingBox box{Vec3::Zero(), Vec3::Zero()};
  double mean_edge = 0;

  bool closed() const { return boundary_edges == 0 && triangles > 0; }
  bool manifold() const { return non_manifold_edges == 0 && non_manifold_vertices == 0; }
  bool oriented() const { return misoriented_edges == 0; }
};

MeshReport inspect_mesh(const TriangleSoup& soup);

/// The largest area of a degenerate triangle on a surface whose bounding box has this diagonal.
double degenerate_area(double diagonal);

/// Why a surface cannot be used for a model, and what to do about it. obstacle_to_model() returns nullopt for
/// one closed, manifold, oriented surface of genus 1 with finite coordinates and valid triangles; inward
/// winding is allowed.
struct Obstacle {
  std::string finding;  ///< e.g. "genus 3"
  std::string advice;   ///< e.g. "repair the surface, which keeps the largest piece, or delete islands ..."
  std::vector<Remedy> remedies = {};
  Message message() const { return {finding + "; " + advice, remedies}; }
};
std::optional<Obstacle> obstacle_to_model(const MeshReport& report);

}  // namespace foramen
