#pragma once
/// \file
/// Closest points on a triangle mesh by a bounding-volume hierarchy.

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

/// The closest point of one triangle; exact also for degenerate triangles.
ClosestPoint closest_on_triangle(const std::array<Vec3, 3>& triangle, const Vec3& query);

class TriangleTree {
 public:
  explicit TriangleTree(const Mesh& mesh);
  /// The closest point. \param within  only points closer than this distance [mm] (empty face id if there is none): a bound from
  /// elsewhere makes the search faster. Ties: the smaller face index.
  ClosestPoint closest(const Vec3& query, double within = std::numeric_limits<double>::infinity()) const;
  /// The closest point on a triangle whose unit normal n has n . normal > min_cosine; nullopt if no triangle has.
  std::optional<ClosestPoint> closest_compatible(const Vec3& query, const Vec3& normal, double min_cosine = 0.0,
                                                 double within = std::numeric_limits<double>::infinity()) const;
  /// Calls `visit` for every face whose distance to the query is <= radius.
  std::vector<FaceId> faces_within(const Vec3& query, double radius) const;
  /// Another mesh of the same connectivity: boxes are recomputed, the hierarchy is kept.
  void refit(const Mesh& mesh);
  const Mesh& mesh() const { return mesh_; }

 private:
  struct Node {
    Vec3 low, high;
    int first = 0, count = 0;   // leaf: faces order_[first .. first+count)
    int right = -1;             // inner: left child follows, right child at `right`
  };
  int build(int first, int count, std::vector<Vec3>& centres);
  Mesh mesh_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
  std::vector<std::array<Vec3, 3>> triangles_;  // in order_
};

}  // namespace foramen
