#pragma once
/// \file
/// Distances and areas defined once on the mean and taken on any shape with the model's landmarks.

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "foramen/core/surface_point.hpp"

namespace foramen {

/// A landmark by its index, or a position beside the mean [mm, model coordinates].
using PlaceOnMean = std::variant<int, Vec3>;

struct NamedPoint {
  std::string name;
  PlaceOnMean place;
};
struct NamedDistance {
  std::string name, from, to;  ///< from, to: names of points
};
/// Landmarks by their indices, or those of the mean's within a ball.
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

/// What a shape's measures are, in the order of the definitions.
struct ShapeMeasures {
  std::vector<Vec3> points;       ///< in the shape's coordinates, mm
  std::vector<double> distances;  ///< straight, mm
  std::vector<double> areas;      ///< of regions, mm^2
};

/// Definitions bound to a mean: a position becomes the closest point of its surface (triangle and barycentric
/// coordinates), a ball the landmarks that the mean has in it. A region is made of the triangles whose three
/// landmarks are in it.
class Measurer {
 public:
  /// Throws InvalidInput, naming the measure: a name that is used twice or not defined, a landmark that is
  /// not there, a region without a triangle, a radius that is not > 0.
  Measurer(const Mesh& mean, const MeasureDefinitions& definitions);
  /// \pre the mean's triangles. Throws InvalidInput for others. Measures are invariant under rigid motion,
  /// points move with the shape.
  ShapeMeasures operator()(const Mesh& shape) const;
  /// The same of the landmarks alone. Throws InvalidInput for another number than the mean's.
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
