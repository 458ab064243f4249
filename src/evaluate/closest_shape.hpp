#pragma once
/// \file
/// The training shape closest to a drawn one, without measuring all of them.

#include <functional>
#include <vector>

#include "evaluate/distance_lattice.hpp"
#include "evaluate/measured_surface.hpp"
#include "evaluate/pruned_distance.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen::detail {

/// Training shapes, and what is worth computing once about them. Fixed while draws are measured.
struct TrainingSurfaces {
  /// \param reach  about how far drawn surfaces leave the middle, mm  \param spacing  of the lattice, mm
  TrainingSurfaces(MeasuredSurface middle_surface, const std::vector<Mesh>& inputs, int samples,
                   std::uint64_t seed, double reach, double spacing, const RunContext& ctx);

  MeasuredSurface middle;
  std::vector<MeasuredSurface> shapes;
  DistanceLattice lattice;
  std::vector<FarthestClusters> starts;         // against the middle surface
  std::vector<std::vector<float>> from_middle;  // distances of each shape's samples to it, mm
};

/// Looks for the closest training shape to each of a sequence of similar surfaces: truncations of one draw.
/// What it remembers from one to the next changes speed alone.
class ClosestShapeSearch {
 public:
  explicit ClosestShapeSearch(const TrainingSurfaces& training);
  /// The surface to be measured next; it must stay as it is until the one after.
  void look_at(const MeasuredSurface& probe);
  /// The smallest Hausdorff distance to a shape. \param needed(i)  distances to shape i up to this number are
  /// wanted although they are not the smallest  \param found(i, d)  is told every distance that was computed
  /// to the end
  double smallest_hausdorff(const std::function<double(std::size_t)>& needed,
                            const std::function<void(std::size_t, double)>& found);
  /// The smallest mean distance to a shape.
  double smallest_mean();

 private:
  double mean_or_beyond(std::size_t shape, double smallest);
  bool backward_bound_beyond(std::size_t shape, double sum);

  const TrainingSurfaces& training_;
  const MeasuredSurface* probe_ = nullptr;
  std::vector<FarthestClusters> starts_;
  std::vector<std::vector<float>> expected_;  // distances of each shape's samples to the probe
  std::vector<float> bounds_;  // samples of the probe x shapes: lower bounds of their distances
  std::vector<double> bound_sum_, bound_max_;  // per shape
};

}  // namespace foramen::detail
