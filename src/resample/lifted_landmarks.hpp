#pragma once
/// \file
/// Landmarks lifted to every shape, and which of their triangles are wrong there.

#include <span>
#include <vector>

#include "foramen/resample/refine_landmarks.hpp"
#include "resample/torus_triangulation.hpp"

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
  /// The corresponding mesh of a shape. \pre no vertex or face of `mesh` was removed.
  Mesh corresponding(int shape, const TorusTriangulation& mesh) const;

 private:
  std::vector<LandmarkShape> shapes_;
  std::vector<std::vector<Vec3>> points_;  // of each shape, per landmark
  std::vector<double> margin_;             // of each shape, mm
};

/// Smallest angle of a triangle, radians.
double smallest_angle(const std::array<Vec3, 3>& triangle);

}  // namespace foramen::detail
