#pragma once
/// \file
/// A surface prepared for distance computations with many others.

#include <cstdint>
#include <span>
#include <vector>

#include "evaluate/packed_triangles.hpp"
#include "foramen/core/mesh.hpp"

namespace foramen::detail {

/// A ball around some of the points of a surface.
struct PointCluster {
  Vec3 centre = Vec3::Zero();
  double radius = 0;
  int first = 0, count = 0;  // points first .. first + count of MeasuredSurface::points()
};

/// The triangles of a mesh for queries, its area-stratified samples, and its vertices and samples grouped in
/// small clusters, so that one query for a ball can decide about all points in it. All these data can be
/// updated for new vertex positions.
class MeasuredSurface {
 public:
  /// \param samples, seed  as in surface_distance()
  MeasuredSurface(const Mesh& mesh, int samples, std::uint64_t seed);
  /// Updates the surface for the same triangles at other positions.
  void move_to(std::vector<Vec3> positions);
  /// Releases the memory that only move_to() needs, which must not be called afterwards. Many surfaces are
  /// kept at once.
  void settle();

  const PackedTriangles& tree() const { return tree_; }
  std::span<const Vec3> samples() const { return samples_; }
  std::span<const PointCluster> clusters() const { return clusters_; }
  /// The vertices and samples of a cluster.
  std::span<const Vec3> points(const PointCluster& cluster) const {
    return std::span(points_).subspan(cluster.first, static_cast<std::size_t>(cluster.count));
  }

 private:
  void gather_clusters();
  void refresh();

  PackedTriangles tree_;
  int sample_count_;
  std::uint64_t seed_;
  std::vector<int> cluster_of_face_;
  std::vector<std::vector<int>> corners_of_cluster_;  // vertices of the faces of each cluster
  std::vector<std::vector<int>> owned_vertices_;      // per cluster; each vertex is in exactly one cluster
  std::vector<Vec3> samples_;
  std::vector<PointCluster> clusters_;
  std::vector<Vec3> points_;
};

}  // namespace foramen::detail
