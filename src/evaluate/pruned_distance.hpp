#pragma once
/// \file
/// Distances between pairs of surfaces, bitwise equal to those of surface_distance() for the same samples.

#include <vector>

#include "evaluate/distance_lattice.hpp"
#include "evaluate/measured_surface.hpp"

namespace foramen::detail {

/// The clusters to test first: those that contained the farthest points in the last comparison of similar
/// surfaces. They affect the speed only.
struct FarthestClusters {
  int of_a = 0, of_b = 0;
};

/// Known bounds of distances to surface b. They affect the speed only.
struct KnownDistances {
  const DistanceLattice* lattice = nullptr;
  std::size_t surface = 0;
  bool surely_within(const Vec3& p, double radius) const {
    return lattice != nullptr && lattice->surely_within(surface, p, radius);
  }
};

/// The Hausdorff distance over samples and vertices, mm. If it exceeds give_up, any number > give_up may be
/// returned.
/// \param at_least  a known lower bound of the distance
double hausdorff_distance(const MeasuredSurface& a, const MeasuredSurface& b, double give_up,
                          FarthestClusters& start, double at_least = 0, const KnownDistances& to_b = {});

/// The distances of all samples of one surface to another, mm.
std::vector<double> sample_distances(const MeasuredSurface& from, const MeasuredSurface& to);

double mean_of(const std::vector<double>& values);

}  // namespace foramen::detail
