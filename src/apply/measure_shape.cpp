#include "foramen/apply/measure_shape.hpp"

#include <algorithm>
#include <set>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/spatial/triangle_tree.hpp"

namespace foramen {
namespace {

[[noreturn]] void refuse(const std::string& kind, const std::string& name, const std::string& what) {
  throw InvalidInput(kind + " \"" + name + "\": " + what);
}

template <class Named>
void require_names_once(const std::string& kind, const std::vector<Named>& all) {
  std::set<std::string> names;
  for (const Named& one : all) {
    if (one.name.empty()) refuse(kind, one.name, "has no name");
    if (!names.insert(one.name).second) refuse(kind, one.name, "is defined twice");
  }
}

void require_landmark(const Mesh& mean, const std::string& kind, const std::string& name, int landmark) {
  if (landmark < 0 || landmark >= mean.vertex_count())
    refuse(kind, name,
           "landmark " + std::to_string(landmark) + " is not there; the model has 0 to " +
               std::to_string(mean.vertex_count() - 1));
}

SurfacePoint at_landmark(const Mesh& mean, int landmark) {
  const HalfedgeId h = mean.outgoing(VertexId(landmark));
  SurfacePoint point{Mesh::face(h), Vec3::Zero()};
  point.barycentric[h.index % 3] = 1;
  return point;
}

std::size_t index_of(const std::vector<NamedPoint>& points, const std::string& kind, const std::string& user,
                     const std::string& name) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].name == name) return i;
  refuse(kind, user, "there is no point \"" + name + "\"; define it among the points");
}

}  // namespace

Measurer::Measurer(const Mesh& mean, const MeasureDefinitions& definitions)
    : landmarks_(mean.positions().size()), triangles_(mean.triangles()) {
  require_names_once("point", definitions.points);
  require_names_once("distance", definitions.distances);
  require_names_once("region", definitions.regions);
  const TriangleTree tree(mean);
  for (const NamedPoint& point : definitions.points) {
    if (const int* landmark = std::get_if<int>(&point.place)) {
      require_landmark(mean, "point", point.name, *landmark);
      points_.push_back(at_landmark(mean, *landmark));
    } else {
      points_.push_back(tree.closest(std::get<Vec3>(point.place)).on);
    }
  }
  for (const NamedDistance& distance : definitions.distances)
    distances_.push_back({index_of(definitions.points, "distance", distance.name, distance.from),
                          index_of(definitions.points, "distance", distance.name, distance.to)});
  for (const NamedRegion& region : definitions.regions) {
    VertexMap<bool> in(mean.vertex_count(), false);
    if (const auto* landmarks = std::get_if<std::vector<int>>(&region.extent)) {
      for (const int landmark : *landmarks) {
        require_landmark(mean, "region", region.name, landmark);
        in[VertexId(landmark)] = true;
      }
    } else {
      const auto& ball = std::get<NamedRegion::Ball>(region.extent);
      if (!(ball.radius_mm > 0)) refuse("region", region.name, "its radius must be > 0 mm");
      const Vec3 centre =
          position(mean, points_[index_of(definitions.points, "region", region.name, ball.centre)]);
      for (VertexId v : mean.vertices()) in[v] = (mean.position(v) - centre).norm() <= ball.radius_mm;
    }
    std::vector<FaceId> faces;
    for (FaceId f : mean.faces()) {
      const auto corners = mean.corners(f);
      if (std::all_of(corners.begin(), corners.end(), [&](VertexId v) { return in[v]; })) faces.push_back(f);
    }
    if (faces.empty()) refuse("region", region.name, "holds no triangle of the mean; make it larger");
    regions_.push_back(std::move(faces));
  }
}

std::array<Vec3, 3> Measurer::triangle(std::span<const Vec3> landmarks, FaceId face) const {
  const auto& [a, b, c] = triangles_[face.index];
  const auto at = [&](int landmark) { return landmarks[landmark]; };
  return {at(a), at(b), at(c)};
}

ShapeMeasures Measurer::operator()(const Mesh& shape) const {
  if (shape.triangles() != triangles_)
    throw InvalidInput("its triangles are not those of the model; give a mesh with the model's landmarks");
  return (*this)(shape.positions());
}

ShapeMeasures Measurer::operator()(std::span<const Vec3> landmarks) const {
  if (landmarks.size() != landmarks_)
    throw InvalidInput("a shape has " + std::to_string(landmarks.size()) + " landmarks, the model " +
                       std::to_string(landmarks_) + "; give shapes with the model's landmarks");
  ShapeMeasures measures;
  for (const SurfacePoint& point : points_) {
    const auto t = triangle(landmarks, point.face);
    const Vec3& b = point.barycentric;
    measures.points.push_back(b[0] * t[0] + b[1] * t[1] + b[2] * t[2]);
  }
  for (const auto& [from, to] : distances_)
    measures.distances.push_back((measures.points[from] - measures.points[to]).norm());
  for (const std::vector<FaceId>& faces : regions_) {
    double sum = 0;
    for (FaceId f : faces) sum += area(triangle(landmarks, f));
    measures.areas.push_back(sum);
  }
  return measures;
}

}  // namespace foramen
