#pragma once
/// \file
/// How far the marks of one name lie apart on the mean of a model.

#include <span>
#include <string>
#include <vector>

#include "foramen/evaluate/mark_transfer.hpp"

namespace foramen {

/// The marks of one name, all drawn on the mean.
struct MarkScatter {
  std::string mark;
  MarkKind kind = MarkKind::point;
  std::vector<PlacedMark> placed;  ///< one per shape that has the mark
  /// The mean of the points of all shapes; of a curve, point by point.
  std::vector<Vec3> centre;
  /// Root mean square over the shapes of the distance of their point to the centre, mm. Of a curve, that of
  /// the distance to the polyline through the centre, averaged over the points of the curve.
  double rms = 0;
};

/// The scatter of each mark, in the order in which they occur.
/// \pre all places are on the mean, and the marks of one name have the same kind and number of places
std::vector<MarkScatter> mark_scatter(const Mesh& mean, std::span<const PlacedMark> placed);

}  // namespace foramen
