#pragma once
/// \file
/// Closest points on a triangle mesh by a bounding-volume hierarchy.

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// A point of the surface that is closest to a query; mm, mm^2.
struct ClosestPoint {
  SurfacePoint on;
  Vec3 point = Vec3::Zero();
  double squared_distance = std::numeric_limits<double>::infinity();
};

/// The point of one triangle that is closest to the query, by the Voronoi regions of the triangle \cite
/// ericson2005. Accurate also for slivers and for triangles of zero area.
ClosestPoint closest_on_triangle(const std::array<Vec3, 3>& triangle, const Vec3& query);

/// Whether a tree keeps normals, which closest_compatible() needs. They take more than half of its memory.
enum class TreeNormals { kept, none };

/// A bounding-volume hierarchy over the triangles of a mesh. All distances are exact point-to-triangle
/// distances in double precision. The boxes are in single precision, rounded outward, and only exclude
/// triangles from the search.
///
/// All const members may be called from many threads at once. The results do not depend on the structure of
/// the hierarchy: of several triangles at the same distance the one of smallest index is returned.
class TriangleTree {
 public:
  explicit TriangleTree(const Mesh& mesh, TreeNormals normals = TreeNormals::kept);
  /// The closest point of the surface.
  /// \param within  only points closer than this distance are found [mm]; if there is none, the face id is
  /// invalid. A known bound makes the search faster.
  ClosestPoint closest(const Vec3& query, double within = std::numeric_limits<double>::infinity()) const;
  /// The closest point on the triangles whose unit normal n satisfies n . normal > min_cosine; nullopt if
  /// there is no such triangle within the distance `within` [mm]. A triangle of zero area has no normal and
  /// is never compatible. \pre TreeNormals::kept
  std::optional<ClosestPoint> closest_compatible(
      const Vec3& query, const Vec3& normal, double min_cosine = 0.0,
      double within = std::numeric_limits<double>::infinity()) const;
  /// Whether some face is at a distance <= radius. If so, this is much cheaper than closest().
  bool any_within(const Vec3& query, double radius) const;
  /// All faces whose distance to the query is <= radius, in order of index.
  std::vector<FaceId> faces_within(const Vec3& query, double radius) const;
  /// Calls `visit` once for every pair of faces whose bounding boxes intersect or touch, with the smaller
  /// index first. The order of the calls depends on the hierarchy.
  void for_each_overlap(const std::function<void(FaceId, FaceId)>& visit) const;
  /// Replaces the mesh by one of the same connectivity: recomputes the boxes and keeps the hierarchy. Throws
  /// InvalidInput if the triangles differ.
  void refit(const Mesh& mesh);
  const Mesh& mesh() const { return mesh_; }

 private:
  using Row = std::array<float, 4>;  // one number for each of the four children

  // Boxes of four children, in coordinates relative to origin_.
  struct alignas(64) Node {
    std::array<Row, 3> low, high;
    std::array<int, 4> child;  // see encode_leaf
  };
  // Bounds of the unit normals of all triangles below each child, per coordinate.
  struct alignas(64) NormalNode {
    std::array<Row, 3> low, high;
  };
  struct Builder;
  struct Query;
  struct Overlaps;
  void refresh();
  std::array<Vec3, 3> triangle(std::size_t slot) const {
    const auto& c = corners_[slot];
    return {mesh_.position(VertexId(c[0])), mesh_.position(VertexId(c[1])), mesh_.position(VertexId(c[2]))};
  }
  template <class Prune, class Visit>
  void traverse(const Query& query, const double& bound, const Prune& prune, const Visit& visit) const;

  Mesh mesh_;
  TreeNormals kept_normals_;
  Vec3 origin_ = Vec3::Zero();
  std::vector<Node> nodes_;               // parents before children
  std::vector<NormalNode> normal_nodes_;  // parallel to nodes_; empty with TreeNormals::none, like normals_
  std::vector<int> order_;  // faces in the order of the leaves; the arrays below have the same order
  // Vertex indices, not points, which would take half of the tree's memory.
  std::vector<std::array<int, 3>> corners_;
  std::vector<Vec3> normals_;
  std::vector<char> sliver_;
};

}  // namespace foramen
