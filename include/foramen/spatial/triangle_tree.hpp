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
#include "foramen/core/surface_point.hpp"

namespace foramen {

struct ClosestPoint {
  SurfacePoint on;
  Vec3 point = Vec3::Zero();
  double squared_distance = std::numeric_limits<double>::infinity();
};

/// The closest point of one triangle (Voronoi regions, Ericson 2005, \cite ericson2005); accurate also for
/// slivers and for triangles without area.
ClosestPoint closest_on_triangle(const std::array<Vec3, 3>& triangle, const Vec3& query);

/// Whether a tree can find the closest triangle of some direction. The normals are more than half of its
/// memory.
enum class TreeNormals { kept, none };

/// The surface of a mesh, arranged for queries. All distances are exact point-to-triangle distances in double
/// precision: the boxes are single precision, rounded outward, and only decide what need not be looked at.
///
/// Every const member may be called from many threads at once. No answer depends on the shape of the
/// hierarchy: of several triangles at the same distance the one of smallest index is returned.
class TriangleTree {
 public:
  explicit TriangleTree(const Mesh& mesh, TreeNormals normals = TreeNormals::kept);
  /// The closest point. \param within  only points closer than this distance [mm] (empty face id if there is
  /// none): a bound from elsewhere makes the search faster. Ties: the smaller face index.
  ClosestPoint closest(const Vec3& query, double within = std::numeric_limits<double>::infinity()) const;
  /// The closest point on a triangle whose unit normal n has n . normal > min_cosine; nullopt if no triangle
  /// has. A triangle without area has no normal and is never compatible. \pre TreeNormals::kept
  std::optional<ClosestPoint> closest_compatible(
      const Vec3& query, const Vec3& normal, double min_cosine = 0.0,
      double within = std::numeric_limits<double>::infinity()) const;
  /// Whether some face is at a distance <= radius: much cheaper than closest() when the answer is yes.
  bool any_within(const Vec3& query, double radius) const;
  /// Every face whose distance to the query is <= radius, in order of index.
  std::vector<FaceId> faces_within(const Vec3& query, double radius) const;
  /// Calls `visit` once for every two faces whose bounding boxes meet (touching is meeting), the smaller
  /// index first. The order of the calls follows the hierarchy.
  void for_each_overlap(const std::function<void(FaceId, FaceId)>& visit) const;
  /// Another mesh of the same connectivity: boxes are recomputed, the hierarchy is kept. Throws InvalidInput
  /// if the triangles differ.
  void refit(const Mesh& mesh);
  const Mesh& mesh() const { return mesh_; }

 private:
  using Row = std::array<float, 4>;  // one number for each of four children
  // Boxes of four children, in coordinates relative to origin_.
  struct alignas(64) Node {
    std::array<Row, 3> low, high;
    std::array<int, 4> child;  // see encode_leaf
  };
  // Ranges of the unit normals below each child, per coordinate.
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
  std::vector<NormalNode> normal_nodes_;  // as nodes_; both these and normals_ empty with TreeNormals::none
  std::vector<int> order_;                // faces in the order of the leaves; the arrays below too
  std::vector<std::array<int, 3>> corners_;  // vertices: half the tree if the points stood here
  std::vector<Vec3> normals_;
  std::vector<char> sliver_;
};

}  // namespace foramen
