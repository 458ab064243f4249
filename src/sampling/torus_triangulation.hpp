#pragma once
/// \file
/// A mutable triangulation of the torus. Flips, collapses and splits are made only if all triangles keep
/// positive areas (decided exactly) and no two edges join the same two vertices.

#include <array>
#include <vector>

#include "foramen/parameterize/torus_map.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "sampling/fixed_torus.hpp"
#include "sampling/remesh.hpp"

namespace foramen::detail {

/// Halfedge 3f+k runs from corner k to corner k+1 of face f, as in Mesh. Removed faces and vertices keep
/// their slots, and landmark_mesh() leaves them out. Ids are plain ints, since the class is private to this
/// room.
class TorusTriangulation {
 public:
  /// \pre closed, jumps consistent; positions within +-4096 turns.
  TorusTriangulation(const Mesh& mesh, const TorusMap& map);
  TorusTriangulation(const std::vector<Vec2>& turns, const std::vector<std::array<int, 3>>& triangles,
                     const HalfedgeMap<Vec2i>& jumps);

  int vertex_slots() const { return static_cast<int>(place_.size()); }
  int face_slots() const { return static_cast<int>(face_alive_.size()); }
  int halfedge_slots() const { return 3 * face_slots(); }
  int vertex_count() const { return live_vertices_; }
  bool alive(int v) const { return outgoing_[v] >= 0; }
  bool face_alive(int f) const { return face_alive_[f] != 0; }

  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int prev(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  int from(int h) const { return from_[h]; }
  int to(int h) const { return from_[next(h)]; }
  int apex(int h) const { return from_[prev(h)]; }
  int twin(int h) const { return twin_[h]; }
  /// The next outgoing halfedge counter-clockwise.
  int rotated(int h) const { return twin_[prev(h)]; }
  int outgoing(int v) const { return outgoing_[v]; }
  std::array<int, 3> corners(int f) const { return {from_[3 * f], from_[3 * f + 1], from_[3 * f + 2]}; }
  int valence(int v) const;
  bool adjacent(int a, int b) const;
  /// Calls visit(halfedge) for every halfedge out of v, counter-clockwise.
  template <class Visit>
  void for_each_outgoing(int v, Visit&& visit) const {
    const int first = outgoing_[v];
    int h = first;
    do {
      visit(h);
      h = rotated(h);
    } while (h != first);
  }

  Fixed2 place(int v) const { return place_[v]; }
  /// Sets the position of a vertex. \pre the caller ensures that all triangles are positive afterwards
  void set_place(int v, Fixed2 p) { place_[v] = p; }
  /// The vector along a halfedge, including its jump.
  Fixed2 along(int h) const { return place_[to(h)] + whole_turns(jump_[h]) - place_[from(h)]; }
  /// Twice the signed area on the torus, exactly.
  Int128 doubled_area(int f) const { return cross(along(3 * f), along(3 * f + 1)); }

  /// Whether a triangle is still usable after a change: positive, and no less than a millionth of the area
  /// that it is cut from or had before. Points that are nearly on a line give triangles that are positive
  /// and yet so thin that the metric of the surface on them is a number without meaning.
  static bool keeps_area(Int128 doubled_area, Int128 before) {
    constexpr Int128 most_shrinkage = 1'000'000;
    return doubled_area > 0 && most_shrinkage * doubled_area >= before;
  }
  /// Whether the edge may be replaced by the other diagonal of its two triangles.
  bool can_flip(int h) const;
  /// Flips the edge and returns the new halfedge from apex(twin(h)) to apex(h), in the old face of h. \pre
  /// can_flip(h)
  int flip(int h);
  /// Whether from(h) may be merged into to(h) and the two triangles at the edge removed.
  bool can_collapse(int h) const;
  void collapse(int h);
  /// Inserts a vertex at `fraction` of the edge and returns it; -1 without change if rounding would give a
  /// triangle of zero area.
  int split_edge(int h, double fraction = 0.5);
  /// Inserts a vertex at the centroid of a face and returns it; -1 without change if the face is too small.
  int split_face(int f);

  /// The triangulation without removed vertices and faces, in the order of slots, with positions in [0, 1).
  LandmarkMesh landmark_mesh() const;

 private:
  void connect_twins();
  void set_face(int f, std::array<int, 3> corners, std::array<Vec2i, 3> jumps);
  void glue(int h, int g);
  int add_vertex(Fixed2 place);
  int add_face();

  std::vector<Fixed2> place_;  // per vertex, anywhere on R^2
  std::vector<int> outgoing_;  // per vertex; -1: removed
  std::vector<int> from_;      // per halfedge
  std::vector<int> twin_;      // per halfedge
  std::vector<Vec2i> jump_;    // per halfedge
  std::vector<char> face_alive_;
  int live_vertices_ = 0;
};

}  // namespace foramen::detail
