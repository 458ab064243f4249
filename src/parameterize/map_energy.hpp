#pragma once
/// \file
/// The energy of a torus map as a function of plane positions and lattice.

#include <array>
#include <vector>

#include "parameterize/distortion.hpp"
#include "parameterize/optimise_map.hpp"

namespace foramen {

/// The variables of the optimisation: plane positions of the vertices (columns of x) and the lattice.
struct MapState {
  Eigen::Matrix2Xd x;
  Lattice lattice = Lattice::Identity();
};

/// Energy = sum over vertices of vertex_weight E_cor + sum over triangles of weight E. The weights include
/// the factor lambda.
class MapEnergy {
 public:
  struct Triangle {
    std::array<int, 3> corner;
    std::array<Vec2, 2> jump;  ///< jumps in turns from corner 0 to corners 1 and 2
    RestTriangle rest;
    double weight = 0;
  };

  /// Throws InvalidInput for a triangle of zero area on the surface or flipped in the map, and for options
  /// that contradict each other.
  MapEnergy(const Mesh& mesh, const TorusMap& start, const OptimiseMapOptions& options,
            const CorrespondenceObjective* objective, const TargetMetric* metric = nullptr);

  /// The energy; +inf if the area of a triangle in the plane is not positive.
  double value(const MapState& state) const;
  /// The weighted correspondence term of one vertex; zero without objective.
  CorrespondenceObjective::Term correspondence(int vertex, const Vec2& plane_position) const;
  /// Area-weighted mean of E over the surface.
  double mean_distortion(const MapState& state) const;

  MapState state(const TorusMap& map) const;
  /// The state as a map with the jumps of the start map.
  TorusMap map(const MapState& state) const;

  const Mesh& mesh() const { return mesh_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  bool has_objective() const { return objective_ != nullptr; }

  /// The edge vectors from corner 0. All code computes them by this function, for the reason given at
  /// doubled_area().
  static Vec4 edges(const Triangle& t, const MapState& state) {
    Vec4 q;
    q.head<2>() = state.x.col(t.corner[1]) - state.x.col(t.corner[0]) + state.lattice * t.jump[0];
    q.tail<2>() = state.x.col(t.corner[2]) - state.x.col(t.corner[0]) + state.lattice * t.jump[1];
    return q;
  }

 private:
  const Mesh& mesh_;
  const TorusMap& start_;
  const CorrespondenceObjective* objective_;
  std::vector<Triangle> triangles_;
  std::vector<double> vertex_weights_;
};

}  // namespace foramen
