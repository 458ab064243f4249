#pragma once
/// \file
/// Curvature-adaptive isotropic remeshing of the mean shape, with torus coordinates for every landmark.

#include <optional>

#include "foramen/core/run_context.hpp"
#include "foramen/parameterize/torus_map.hpp"

namespace foramen {

/// A triangulation of the torus whose vertices are landmarks.
struct LandmarkMesh {
  std::vector<Vec2> turns;                        ///< of each landmark
  std::vector<std::array<int, 3>> triangles;
  HalfedgeMap<Vec2i> jumps;                       ///< of halfedge 3f+k: an embedding of the torus like any torus map
};

struct RemeshOptions {
  int landmarks = 4000;
  double contrast = 1.0;           ///< density = curvature^contrast (after clamping); 0: uniform
  double density_floor = 0.1;      ///< smallest density relative to the largest, > 0: flat regions get samples too
  int smoothing_rounds = 10;       ///< of the density, half-way to the neighbours' mean each
  int relaxation_rounds = 50;      ///< Lloyd
  std::uint64_t seed = 1;
};

/// Fuhrmann et al. 2010 on the dense mean `surface` with its torus map: exactly options.landmarks vertices on the surface, genus kept,
/// no triangle flipped on the torus, Delaunay edges, Lloyd relaxation weighted by density.
/// \param density  per vertex of `surface`, > 0; see curvature_density()
LandmarkMesh remesh(const Mesh& surface, const TorusMap& map, const VertexMap<double>& density, const RunContext& ctx,
                    const RemeshOptions& options = {});

/// Curvature (|K| + H^2) / 2 per vertex, clamped relative to the shape's size, raised to `contrast`, with a floor, smoothed.
VertexMap<double> curvature_density(const Mesh& surface, const RemeshOptions& options = {});

}  // namespace foramen
