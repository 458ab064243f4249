#pragma once
/// \file
/// Isotropic remeshing on an implicit surface.

#include "synth/isosurface.hpp"

namespace foramen::synth {

/// Projects a point to the surface by Newton steps along the gradient, each at most `longest_step_mm` long.
struct Projected {
  Vec3 point;
  Vec3 normal;
  double residual;  ///< |f| [mm]
};
Projected projected(const ImplicitFunction& function, const Vec3& from, double longest_step_mm);

/// A closed manifold mesh with vertices on an implicit surface, remeshed in place. Every operation preserves
/// the topology and creates no two edges between the same vertices. The normals of all new triangles agree
/// with the gradient.
class ImplicitRemesher {
 public:
  /// Projects the vertices of `soup` to the surface.
  ImplicitRemesher(const ImplicitFunction& function, TriangleSoup soup, double spacing_mm);

  int vertex_count() const { return vertex_count_; }
  double area() const;
  /// Splits edges longer than 4/3 of the given length, collapses edges shorter than 4/5 of it, makes Delaunay
  /// flips and smooths.
  void equalise(double edge_length);
  /// Collapses the shortest or splits the longest edges until the mesh has `target` vertices or no further
  /// change is possible.
  void adjust_vertex_count(int target);
  /// Makes flips and smooths, without changing the number of vertices.
  void polish();
  /// The largest |f| at a vertex.
  double residual() const;
  TriangleSoup soup() const;

 private:
  struct Edge {
    double length;
    int a, b;  // a < b
    friend auto operator<=>(const Edge&, const Edge&) = default;
  };
  using Triangle = std::array<int, 3>;

  /// The edges with lengths in this range, in the order of the triangles.
  std::vector<Edge> edges(double shortest, double longest) const;
  double length(int a, int b) const;
  bool alive(int v) const { return !star_[v].empty(); }
  bool adjacent(int a, int b) const;
  std::vector<int> neighbours(int v) const;  // ascending
  // The faces to the left and right of the edge from a to b and their opposite corners; all -1 if there is no
  // such edge.
  struct EdgeFaces {
    int left = -1, right = -1, above = -1, below = -1;
  };
  EdgeFaces edge_faces(int a, int b) const;
  // Whether v may be moved to `to`: every triangle at v, except those with a vertex in `except`, must then
  // face outward or at least not less than before.
  bool may_move(int v, const Projected& to, std::array<int, 2> except) const;
  double longest_edge_after_move(int v, const Vec3& to) const;
  bool collapse(int a, int b, double longest_allowed);
  bool split(int a, int b);
  bool flip(int a, int b);
  void flip_all();
  void smooth_all();
  void replace_corner(int face, int from, int to);
  void detach(int face, int vertex);

  const ImplicitFunction& function_;
  double step_limit_;
  int vertex_count_ = 0;
  std::vector<Vec3> points_, normals_;
  std::vector<Triangle> faces_;         // removed faces have corners -1
  std::vector<std::vector<int>> star_;  // faces of each vertex
};

}  // namespace foramen::synth
