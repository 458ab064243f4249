#pragma once
/// \file
/// Distances to a triangle mesh, many and fast, for a mesh whose vertices keep moving.

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen::detail {

/// Triangles four to a packet, packets under a hierarchy of boxes four to a node. Single precision decides,
/// with room for its own error, which few triangles can be the closest; their distances are then exact, so
/// every answer is that of TriangleTree to the bit. Const members may be called from many threads at once.
class PackedTriangles {
 public:
  explicit PackedTriangles(const Mesh& mesh);
  /// The same triangles at other positions: numbers are recomputed, the hierarchy is kept.
  void move_to(std::vector<Vec3> positions);

  double squared_distance(const Vec3& query) const;
  /// A lower bound of the distance, at most a sixth below it, for a third of the time.
  double distance_at_least(const Vec3& query) const;
  /// Whether the surface is at a distance <= radius.
  bool any_within(const Vec3& query, double radius) const;
  const Mesh& mesh() const { return mesh_; }

 private:
  using Lanes = std::array<float, 4>;
  /// Corner a and sides of four triangles a, a + ab, a + ac, relative to origin_, and what depends on them
  /// alone.
  struct alignas(64) Packet {
    std::array<Lanes, 3> a, ab, ac;
    Lanes ab_ab, ab_ac, ac_ac, bc_bc;
    Lanes inverse_ab, inverse_ac, inverse_bc, inverse_det;  // of squared lengths and of the Gram determinant
    Lanes doubt;              // added to what is taken for rounding; infinite for slivers
    std::array<int, 4> face;  // repeated where there are fewer than four
  };
  struct alignas(64) Node {
    std::array<Lanes, 3> low, high;
    std::array<int, 4> child;  // a node, the complement of a packet, or no_child, whose box is infinitely far
  };
  struct Query;
  struct Builder;
  void refresh();
  void fill(Packet& packet) const;
  template <class Visit, class Skipped>
  void traverse(const Query& query, const float& limit, const Visit& visit, Skipped& skipped) const;

  Mesh mesh_;
  Vec3 origin_ = Vec3::Zero();
  float rounding_ = 0;  // relative error allowed for in single precision
  std::vector<Packet> packets_;
  std::vector<Node> nodes_;  // parents before children
};

}  // namespace foramen::detail
