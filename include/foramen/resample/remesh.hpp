#pragma once
/// \file
/// Curvature-adaptive isotropic remeshing of the mean shape, with torus coordinates for every landmark.

#include <array>
#include <cstdint>
#include <vector>

#include "foramen/core/run_context.hpp"
#include "foramen/parameterize/torus_map.hpp"

namespace foramen {

/// A triangulation of the torus whose vertices are landmarks.
struct LandmarkMesh {
  std::vector<Vec2> turns;  ///< of each landmark
  std::vector<std::array<int, 3>> triangles;
  HalfedgeMap<Vec2i> jumps;  ///< of halfedge 3f+k: an embedding of the torus like any torus map
};

/// The defaults are the middle of a wide plateau: on real lumbar vertebrae the error of representation hardly
/// changes for contrasts of 0.35 to 0.5, floors of 0.05 to 0.15 and radii of 0.007 to 0.015.
struct RemeshOptions {
  int landmarks = 4000;
  /// density = curvature^contrast, >= 0; 0: uniform. 0.5 spreads the largest error evenly (an edge of length
  /// h misses a surface of curvature k by h^2 k / 8, and the curvature measured here is of the kind k^2),
  /// 0.25 lessens the mean.
  double contrast = 0.5;
  /// Smallest density relative to the largest, in (0, 1]: flat regions get samples too.
  double density_floor = 0.15;
  int smoothing_rounds = 5;    ///< of the density, half-way to the neighbours' mean each
  int relaxation_rounds = 80;  ///< Lloyd
  /// Standard deviation of the kernel over which the curvature tensor is averaged before its curvature is
  /// taken, relative to the square root of the surface's area; > 0. It decides what is a feature and what a
  /// voxel's step: about 1 mm on a vertebra.
  double curvature_radius = 0.008;
};

/// Isotropic remeshing of the dense mean `surface` after \cite fuhrmann2010, in another order: halfedge
/// collapses down to (or edge splits up to) exactly options.landmarks vertices, the edge that is shortest in
/// the density's metric first; Delaunay flips; Lloyd relaxation weighted by density, each landmark moved
/// within its one-ring and put back on the surface through the torus; Delaunay flips.
///
/// Every landmark lies on the surface; the triangles are an embedded triangulation of the torus at every step
/// (exactly, in steps of 2^-40 turns), no two edges join the same two landmarks, and the genus is kept. The
/// same for any number of threads.
///
/// \param density  samples per area up to a factor, per vertex of `surface`, > 0; see curvature_density()
///
/// Throws InvalidInput (fewer than 16 landmarks, a density that is not positive, a map with flipped
/// triangles) or ConvergenceError (the surface cannot be thinned out that far).
LandmarkMesh remesh(const Mesh& surface, const TorusMap& map, const VertexMap<double>& density,
                    const RunContext& ctx, const RemeshOptions& options = {});

/// \f$ ((|K| + H^2) / 2)^{contrast} \f$ per vertex, \cite fuhrmann2010, clamped at the 99 % quantile of the
/// curvature, scaled to a largest value of 1, raised to the floor, smoothed. K and H come from the
/// normal-cycle curvature tensor (\cite cohensteiner2003) averaged over options.curvature_radius, in which
/// the steps of a voxel surface cancel.
VertexMap<double> curvature_density(const Mesh& surface, const RemeshOptions& options = {});

}  // namespace foramen
