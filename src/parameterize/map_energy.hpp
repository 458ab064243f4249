#pragma once
/// \file
/// The energy of a torus map as a function of plane positions and lattice, triangle by triangle.

#include <array>
#include <vector>

#include "parameterize/distortion.hpp"
#include "parameterize/optimise_map.hpp"

namespace foramen {

/// What is optimised: a plane position per vertex (columns of x) and the lattice.
struct MapState {
  Eigen::Matrix2Xd x;
  Lattice lattice = Lattice::Identity();
};

/// Energy = sum over vertices of vertex_weight E_cor + sum over triangles of weight E. The factor lambda is
/// in the weights.
class MapEnergy {
 public:
  struct Triangle {
    std::array<int, 3> corner;
    std::array<Vec2, 2> jump;  ///< turns from corner 0 to corners 1 and 2
    RestTriangle rest;
    double weight = 0;
  };

  /// \throws InvalidInput for a triangle without area on the surface or flipped in the map, and for options
  /// that contradict.
  MapEnergy(const Mesh& mesh, const TorusMap& start, const OptimiseMapOptions& options,
            const CorrespondenceObjective* objective, const TargetMetric* metric = nullptr);

  /// +inf if a triangle's area in the plane is not positive.
  double value(const MapState& state) const;
  /// The correspondence part alone, at one vertex and with its weight; zero without objective.
  CorrespondenceObjective::Term correspondence(int vertex, const Vec2& plane_position) const;
  /// Area-weighted mean of E over the surface.
  double mean_distortion(const MapState& state) const;

  MapState state(const TorusMap& map) const;
  /// The state as a map with the jumps of the start.
  TorusMap map(const MapState& state) const;

  const Mesh& mesh() const { return mesh_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  bool has_objective() const { return objective_ != nullptr; }

  /// The edge vectors from corner 0. The only place where they are computed from a state: see doubled_area().
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
