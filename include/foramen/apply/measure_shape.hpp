#pragma once
/// \file
/// Distances and areas that are defined on the mean and measured on any shape with the model's landmarks.

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// The index of a landmark, or a position near the mean [mm, model coordinates].
using PlaceOnMean = std::variant<int, Vec3>;

/// A named point of the mean.
struct NamedPoint {
  std::string name;
  PlaceOnMean place;
};
/// The distance between two named points.
struct NamedDistance {
  std::string name, from, to;  ///< from, to: names of points
};
/// A region: landmarks given by index, or all landmarks of the mean in a ball.
struct NamedRegion {
  struct Ball {
    std::string centre;  ///< name of a point
    double radius_mm = 0;
  };
  std::string name;
  std::variant<std::vector<int>, Ball> extent;
};

struct MeasureDefinitions {
  std::vector<NamedPoint> points;
  std::vector<NamedDistance> distances;
  std::vector<NamedRegion> regions;
};

/// The measures of a shape, in the order of the definitions.
struct ShapeMeasures {
  std::vector<Vec3> points;       ///< in the shape's coordinates, mm
  std::vector<double> distances;  ///< straight-line distances, mm
  std::vector<double> areas;      ///< areas of the regions, mm^2
};

/// Applies definitions to shapes. A position becomes the closest surface point of the mean (triangle and
/// barycentric coordinates), and a ball becomes the set of landmarks of the mean in it. A region consists of
/// the triangles whose three landmarks belong to it.
class Measurer {
 public:
  /// Throws InvalidInput with the name of the measure: a name that is used twice or not defined, a landmark
  /// that does not exist, a region without triangles, a radius that is not > 0.
  Measurer(const Mesh& mean, const MeasureDefinitions& definitions);
  /// Measures a shape with the triangles of the mean. Distances and areas are invariant under rigid motion,
  /// and points move with the shape. Throws InvalidInput if the triangles differ from those of the mean.
  ShapeMeasures operator()(const Mesh& shape) const;
  /// The same for the landmarks only. Throws InvalidInput if their number differs from that of the mean.
  ShapeMeasures operator()(std::span<const Vec3> landmarks) const;

 private:
  std::array<Vec3, 3> triangle(std::span<const Vec3> landmarks, FaceId face) const;

  std::size_t landmarks_ = 0;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<SurfacePoint> points_;
  std::vector<std::array<std::size_t, 2>> distances_;  // indices of points
  std::vector<std::vector<FaceId>> regions_;
};

}  // namespace foramen
