#pragma once
/// \file
/// Search for the training shape closest to a drawn shape without computing all distances.

#include <functional>
#include <vector>

#include "evaluate/distance_lattice.hpp"
#include "evaluate/measured_surface.hpp"
#include "evaluate/pruned_distance.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen::detail {

/// The training shapes with data that are computed once for all draws.
struct TrainingSurfaces {
  /// \param reach  approximate largest distance of drawn surfaces from the middle surface, mm
  /// \param spacing  spacing of the lattice, mm
  TrainingSurfaces(MeasuredSurface middle_surface, const std::vector<Mesh>& inputs, int samples,
                   std::uint64_t seed, double reach, double spacing, const RunContext& ctx);

  MeasuredSurface middle;
  std::vector<MeasuredSurface> shapes;
  DistanceLattice lattice;
  std::vector<FarthestClusters> starts;         // initial values, from the comparison with the middle surface
  std::vector<std::vector<float>> from_middle;  // distances of each shape's samples to the middle surface, mm
};

/// Finds the closest training shape for each of a sequence of similar surfaces, the truncations of one draw.
/// Results of one surface serve as guesses for the next; they affect the speed only.
class ClosestShapeSearch {
 public:
  explicit ClosestShapeSearch(const TrainingSurfaces& training);
  /// Sets the surface to measure next. It must not change until the next call of look_at().
  void look_at(const MeasuredSurface& probe);
  /// The smallest Hausdorff distance to a training shape. `needed(i)` is a limit up to which the distance to
  /// shape i is computed even if it is not the smallest. `found(i, d)` is called with every distance that was
  /// computed completely.
  double smallest_hausdorff(const std::function<double(std::size_t)>& needed,
                            const std::function<void(std::size_t, double)>& found);
  /// The smallest mean distance to a training shape.
  double smallest_mean();

 private:
  double mean_or_beyond(std::size_t shape, double smallest);
  bool backward_bound_beyond(std::size_t shape, double sum);

  const TrainingSurfaces& training_;
  const MeasuredSurface* probe_ = nullptr;
  std::vector<FarthestClusters> starts_;
  std::vector<std::vector<float>> expected_;   // distances of each shape's samples to the probe
  std::vector<float> bounds_;                  // lower bounds of distances: samples of the probe x shapes
  std::vector<double> bound_sum_, bound_max_;  // per shape
};

}  // namespace foramen::detail
