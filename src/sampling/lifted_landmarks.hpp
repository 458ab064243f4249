#pragma once
/// \file
/// Landmarks lifted to all shapes, and tests of their triangles on each shape.

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
  /// Lifts a moved or new vertex to all shapes.
  void update(int vertex, Fixed2 place);
  /// Whether a triangle is degenerate or confirmed-flipped on a shape (the definition of sampled_flips()).
  bool guilty(int shape, const std::array<Vec3, 3>& triangle) const;
  /// Recomputes the margin within which a flip must be confirmed: 0.25 mean landmark edges beyond the closest
  /// point, per shape.
  void measure_edges(const TorusTriangulation& mesh);
  /// Stores the present landmark mesh of a shape for faces_met().
  void refresh_surface(int shape, const TorusTriangulation& mesh);
  void forget_surface(int shape) { surfaces_[shape].reset(); }
  /// The stored mesh; null if there is none.
  const TriangleTree* surface(int shape) const { return surfaces_[shape] ? &*surfaces_[shape] : nullptr; }
  /// The faces of surface() that a triangle intersects; none if no mesh is stored.
  std::vector<FaceId> faces_met(int shape, const NumberedTriangle& triangle) const;
  /// The landmark mesh of a shape. \pre no vertex or face of `mesh` was removed
  Mesh corresponding(int shape, const TorusTriangulation& mesh) const;

 private:
  std::vector<LandmarkShape> shapes_;
  std::vector<std::vector<Vec3>> points_;              // of each shape, per landmark
  std::vector<double> margin_;                         // of each shape, mm
  std::vector<std::optional<TriangleTree>> surfaces_;  // of each shape, as refreshed
};

/// Whether the two triangles intersect and both have an area.
bool meet(const NumberedTriangle& a, const NumberedTriangle& b);

/// Smallest angle of a triangle, radians.
double smallest_angle(const std::array<Vec3, 3>& triangle);

}  // namespace foramen::detail
