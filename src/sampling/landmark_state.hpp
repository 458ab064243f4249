#pragma once
/// \file
/// The state of remeshing: a triangulation of the torus and the positions of its vertices on the dense
/// surface.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "sampling/lift_to_surface.hpp"
#include "sampling/torus_triangulation.hpp"

namespace foramen::detail {

/// The dense surface, evaluated at torus positions.
class DenseSurface {
 public:
  struct Sample {
    Vec3 point;
    double density;
  };
  DenseSurface(const Mesh& mesh, const TorusMap& map, const VertexMap<double>& density)
      : mesh_(mesh), density_(density), locator_(mesh, map) {}
  Sample at(Fixed2 place) const {
    const SurfacePoint p = locator_.locate(to_turns(place - whole_turns(floor_turns(place))));
    const auto c = mesh_.corners(p.face);
    const Vec3& b = p.barycentric;
    return {position(mesh_, p), b[0] * density_[c[0]] + b[1] * density_[c[1]] + b[2] * density_[c[2]]};
  }

 private:
  const Mesh& mesh_;
  const VertexMap<double>& density_;
  TorusLocator locator_;
};

/// The triangulation with the surface point and density of each vertex slot.
struct LandmarkState {
  TorusTriangulation mesh;
  std::vector<Vec3> point;
  std::vector<double> density;

  void update(int v, const DenseSurface& surface) {
    const auto sample = surface.at(mesh.place(v));
    point[v] = sample.point;
    density[v] = sample.density;
  }
  /// Squared length of an edge in units of the wanted edge length, which follows from the density (samples
  /// per area).
  double scaled_length2(int h) const {
    const int a = mesh.from(h), b = mesh.to(h);
    return (point[a] - point[b]).squaredNorm() * 0.5 * (density[a] + density[b]);
  }
};

/// Twice the area vector of a triangle.
inline Vec3 doubled_area_vector(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a); }

/// Cosine of the angle between two vectors; 0 if one of them is zero.
inline double cosine(const Vec3& a, const Vec3& b) {
  const double scale = std::sqrt(a.squaredNorm() * b.squaredNorm());
  return scale > 0 ? a.dot(b) / scale : 0.0;
}

}  // namespace foramen::detail
