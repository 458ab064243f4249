#pragma once
/// \file
/// Landmarks lifted to every shape, and which of their triangles are wrong there.

#include <optional>
#include <span>
#include <vector>

#include "sampling/refine_landmarks.hpp"
#include "sampling/torus_triangulation.hpp"
#include "spatial/triangles_meet.hpp"

namespace foramen::detail {

class LiftedLandmarks {
 public:
  LiftedLandmarks(std::span<const LandmarkShape> shapes, const TorusTriangulation& mesh,
                  const RunContext& ctx);

  int shapes() const { return static_cast<int>(shapes_.size()); }
  Vec3 lift(int shape, Fixed2 place) const;
  const Vec3& point(int shape, int vertex) const { return points_[shape][vertex]; }
  /// Lifts a moved or new vertex again, to all shapes.
  void update(int vertex, Fixed2 place);
  /// Whether a triangle is degenerate or confirmed-flipped on a shape (the definition of sampled_flips()).
  bool guilty(int shape, const std::array<Vec3, 3>& triangle) const;
  /// The distance beyond the closest point within which a flip must be confirmed: 0.25 mean landmark edge.
  void measure_edges(const TorusTriangulation& mesh);
  /// Keeps the corresponding mesh of a shape as it is now, for faces_met().
  void refresh_surface(int shape, const TorusTriangulation& mesh);
  void forget_surface(int shape) { surfaces_[shape].reset(); }
  /// The mesh that is kept, if any.
  const TriangleTree* surface(int shape) const { return surfaces_[shape] ? &*surfaces_[shape] : nullptr; }
  /// The faces of surface() that a triangle meets; none if there is no surface().
  std::vector<FaceId> faces_met(int shape, const NumberedTriangle& triangle) const;
  /// The corresponding mesh of a shape. \pre no vertex or face of `mesh` was removed.
  Mesh corresponding(int shape, const TorusTriangulation& mesh) const;

 private:
  std::vector<LandmarkShape> shapes_;
  std::vector<std::vector<Vec3>> points_;              // of each shape, per landmark
  std::vector<double> margin_;                         // of each shape, mm
  std::vector<std::optional<TriangleTree>> surfaces_;  // of each shape, as refreshed
};

/// Whether both triangles have area and meet.
bool meet(const NumberedTriangle& a, const NumberedTriangle& b);

/// Smallest angle of a triangle, radians.
double smallest_angle(const std::array<Vec3, 3>& triangle);

}  // namespace foramen::detail
