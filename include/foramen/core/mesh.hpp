#pragma once
/// \file
/// Triangle surfaces: the unchecked triangle soup that files hold, the immutable manifold mesh on which all
/// algorithms work, points on it, and its exchange with Eigen matrices.

#include <array>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "foramen/core/ids.hpp"

namespace foramen {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec2i = Eigen::Vector2i;
using Mat2 = Eigen::Matrix2d;
using Mat3 = Eigen::Matrix3d;

/// Points and index triples without any guarantee of validity. File readers return it and file writers take
/// it.
struct TriangleSoup {
  std::vector<Vec3> points;                   ///< mm
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from outside
};

/// An immutable, oriented 2-manifold triangle mesh with or without boundary. Copies share positions and
/// connectivity.
///
/// Halfedge 3f+k runs from corner k to corner k+1 (mod 3) of face f, so faces and halfedges need no tables.
/// Every vertex has at least one face and a one-ring that is one disk or one half-disk.
class Mesh {
 public:
  Mesh() = default;

  int vertex_count() const { return static_cast<int>(positions_->size()); }
  int face_count() const { return static_cast<int>(connectivity_->triangles.size()); }
  int halfedge_count() const { return 3 * face_count(); }
  int edge_count() const { return static_cast<int>(connectivity_->edge_halfedge.size()); }
  IdRange<VertexId> vertices() const { return IdRange<VertexId>(vertex_count()); }
  IdRange<FaceId> faces() const { return IdRange<FaceId>(face_count()); }
  IdRange<EdgeId> edges() const { return IdRange<EdgeId>(edge_count()); }
  IdRange<HalfedgeId> halfedges() const { return IdRange<HalfedgeId>(halfedge_count()); }

  const Vec3& position(VertexId v) const { return (*positions_)[v.index]; }
  std::span<const Vec3> positions() const { return *positions_; }
  const std::vector<std::array<int, 3>>& triangles() const { return connectivity_->triangles; }
  std::array<VertexId, 3> corners(FaceId f) const {
    const auto& t = connectivity_->triangles[f.index];
    return {VertexId(t[0]), VertexId(t[1]), VertexId(t[2])};
  }
  std::array<Vec3, 3> triangle(FaceId f) const {
    const auto c = corners(f);
    return {position(c[0]), position(c[1]), position(c[2])};
  }

  static FaceId face(HalfedgeId h) { return FaceId(h.index / 3); }
  static HalfedgeId halfedge(FaceId f, int corner) { return HalfedgeId(3 * f.index + corner); }
  static HalfedgeId next(HalfedgeId h) { return HalfedgeId(h.index % 3 == 2 ? h.index - 2 : h.index + 1); }
  static HalfedgeId prev(HalfedgeId h) { return HalfedgeId(h.index % 3 == 0 ? h.index + 2 : h.index - 1); }
  VertexId from(HalfedgeId h) const { return VertexId(connectivity_->triangles[h.index / 3][h.index % 3]); }
  VertexId to(HalfedgeId h) const { return from(next(h)); }
  /// The opposite halfedge; invalid on the boundary.
  HalfedgeId twin(HalfedgeId h) const { return connectivity_->twin[h.index]; }
  EdgeId edge(HalfedgeId h) const { return connectivity_->halfedge_edge[h.index]; }
  /// One halfedge of the edge (the one of smaller index).
  HalfedgeId halfedge(EdgeId e) const { return connectivity_->edge_halfedge[e.index]; }
  /// An outgoing halfedge of v. At a boundary vertex it is the one from which rotated() reaches all others.
  HalfedgeId outgoing(VertexId v) const { return connectivity_->vertex_halfedge[v.index]; }
  /// The next outgoing halfedge of from(h) in counter-clockwise order; invalid beyond the boundary.
  HalfedgeId rotated(HalfedgeId h) const { return twin(prev(h)); }
  /// All outgoing halfedges of v, counter-clockwise. A boundary vertex has one neighbour more than that:
  /// from(prev(last)).
  std::vector<HalfedgeId> fan(VertexId v) const;
  /// The halfedge from a to b; invalid if the mesh has none in that direction.
  HalfedgeId find_halfedge(VertexId a, VertexId b) const;

  bool is_boundary(VertexId v) const { return !twin(outgoing(v)).valid(); }
  bool is_closed() const { return connectivity_->closed; }
  /// V - E + F.
  int euler_characteristic() const { return vertex_count() - edge_count() + face_count(); }

  /// Returns a mesh of the same connectivity with other positions. \pre one position per vertex.
  Mesh with_positions(std::vector<Vec3> positions) const;
  TriangleSoup soup() const { return {*positions_, connectivity_->triangles}; }

 private:
  friend Mesh build_mesh(TriangleSoup soup);
  struct Connectivity {
    std::vector<std::array<int, 3>> triangles;
    std::vector<HalfedgeId> twin;             // per halfedge
    std::vector<EdgeId> halfedge_edge;        // per halfedge
    std::vector<HalfedgeId> edge_halfedge;    // per edge
    std::vector<HalfedgeId> vertex_halfedge;  // per vertex
    bool closed = true;
  };
  std::shared_ptr<const std::vector<Vec3>> positions_ = std::make_shared<const std::vector<Vec3>>();
  std::shared_ptr<const Connectivity> connectivity_ = std::make_shared<const Connectivity>();
};

/// Builds the connectivity. The message of an error names the first element at fault.
///
/// Throws InvalidInput for an index out of range, a triangle that uses a corner twice or a coordinate that is
/// not finite. Throws TopologyError for an edge with more than two triangles or with two triangles that run
/// along it in the same direction, for a vertex whose triangles do not form one fan, and for a vertex without
/// triangles.
Mesh build_mesh(TriangleSoup soup);

/// Barycentric coordinates in a face; they sum to 1, each >= 0 up to rounding.
struct SurfacePoint {
  FaceId face;
  Vec3 barycentric = Vec3::Zero();
};

/// The position in space, mm.
inline Vec3 position(const Mesh& mesh, const SurfacePoint& p) {
  const auto t = mesh.triangle(p.face);
  return p.barycentric[0] * t[0] + p.barycentric[1] * t[1] + p.barycentric[2] * t[2];
}

/// Builds a mesh from matrices. Throws what build_mesh() throws.
/// \param points  one row per vertex, mm
/// \param triangles  one row per face: the indices of its corners, counter-clockwise seen from outside
Mesh mesh_from_matrices(const Eigen::Ref<const Eigen::MatrixX3d>& points,
                        const Eigen::Ref<const Eigen::MatrixX3i>& triangles);

/// Returns one row per point.
Eigen::MatrixX3d matrix_of(std::span<const Vec3> points);
/// Returns one row per triangle.
Eigen::MatrixX3i matrix_of(std::span<const std::array<int, 3>> triangles);

}  // namespace foramen
