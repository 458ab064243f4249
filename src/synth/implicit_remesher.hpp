#pragma once
/// \file
/// Isotropic remeshing on an implicit surface.

#include "synth/isosurface.hpp"

namespace foramen::synth {

/// Moves a point to the surface by Newton steps along the gradient, each at most `longest_step_mm`.
/// Returns the point and the unit normal there.
struct Projected {
  Vec3 point;
  Vec3 normal;
  double residual;  ///< |f| [mm]
};
Projected projected(const ImplicitFunction& function, const Vec3& from, double longest_step_mm);

/// A closed manifold mesh whose vertices lie on the surface, edited in place. Every edit keeps the topology,
/// leaves no two edges between the same vertices, and keeps every triangle it makes facing the way of the
/// gradient.
class ImplicitRemesher {
 public:
  /// The vertices of `soup` are projected first.
  ImplicitRemesher(const ImplicitFunction& function, TriangleSoup soup, double spacing_mm);

  int vertex_count() const { return vertex_count_; }
  double area() const;
  /// Splits edges longer than 4/3 of the length, collapses those shorter than 4/5, flips to larger angles,
  /// smooths.
  void equalise(double edge_length);
  /// Collapses the shortest or splits the longest edges until the mesh has that many vertices, or as near as
  /// it gets.
  void adjust_vertex_count(int target);
  /// Flips and smooths only.
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

  /// Those of such lengths, in the order of the triangles.
  std::vector<Edge> edges(double shortest, double longest) const;
  double length(int a, int b) const;
  bool alive(int v) const { return !star_[v].empty(); }
  bool adjacent(int a, int b) const;
  std::vector<int> neighbours(int v) const;  // ascending
  // The faces with the edge from a to b and from b to a, and the corners opposite to it. {-1 ...} if a, b
  // share no edge.
  struct EdgeFaces {
    int left = -1, right = -1, above = -1, below = -1;
  };
  EdgeFaces edge_faces(int a, int b) const;
  // Whether every triangle at v, but for those in `except`, would face outward with v there, or at least no
  // worse than now.
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
  std::vector<Triangle> faces_;         // removed ones have corner -1
  std::vector<std::vector<int>> star_;  // faces of each vertex
};

}  // namespace foramen::synth
