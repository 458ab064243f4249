#pragma once
/// \file
/// Distances of pairs of surfaces. To the bit what surface_distance gives for the same samples.

#include <vector>

#include "evaluate/distance_lattice.hpp"
#include "evaluate/measured_surface.hpp"

namespace foramen::detail {

/// Where to look first: clusters that held the farthest points the last time similar surfaces were compared.
/// Changes speed alone.
struct FarthestClusters {
  int of_a = 0, of_b = 0;
};

/// What is known of distances to surface b beforehand. Changes speed alone.
struct KnownDistances {
  const DistanceLattice* lattice = nullptr;
  std::size_t surface = 0;
  bool surely_within(const Vec3& p, double radius) const {
    return lattice != nullptr && lattice->surely_within(surface, p, radius);
  }
};

/// The Hausdorff distance over samples and vertices, or some number > give_up if it is > give_up.
/// \param at_least  a number known not to exceed the distance
double hausdorff_distance(const MeasuredSurface& a, const MeasuredSurface& b, double give_up,
                          FarthestClusters& start, double at_least = 0, const KnownDistances& to_b = {});

/// Distances of all samples of one surface to another, mm.
std::vector<double> sample_distances(const MeasuredSurface& from, const MeasuredSurface& to);

double mean_of(const std::vector<double>& values);

}  // namespace foramen::detail
