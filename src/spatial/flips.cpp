#include "spatial/flips.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <Eigen/SVD>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"

namespace foramen {
namespace {

// Mean edge lengths. On a thin wall the closest point may lie on the other side of the wall, so input
// triangles that are farther by this much are tested, too.
constexpr double confirming_edges = 0.25;
constexpr double degenerate_height = 1e-12;
// An upper bound of the error of a height, in rounding errors of one coordinate: three corners are rounded in
// three coordinates each.
constexpr double rounding_errors = 8;

bool is_degenerate(const std::array<Vec3, 3>& t, double least_height_mm = 0) {
  const double longest2 =
      std::max({(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()});
  const double longest = std::sqrt(longest2);
  // Twice the area = longest side times height.
  return 2 * area(t) <= std::max(degenerate_height * longest2, least_height_mm * longest);
}

bool opposes(const Vec3& normal, const Mesh& input, FaceId face) {
  return area_vector(input.triangle(face)).dot(normal) < 0;
}

bool opposes_all(const Vec3& normal, const Mesh& input, const std::vector<FaceId>& faces) {
  return std::all_of(faces.begin(), faces.end(),
                     [&](FaceId f) { return is_degenerate(input.triangle(f)) || opposes(normal, input, f); });
}

Mat3 rotation_onto(const Mesh& moving, const Mesh& fixed) {
  const auto columns = [](const Mesh& mesh) {
    Eigen::Matrix3Xd points(3, mesh.vertex_count());
    for (VertexId v : mesh.vertices()) points.col(v.index) = mesh.position(v);
    return points;
  };
  return Eigen::umeyama(columns(moving), columns(fixed), false).topLeftCorner<3, 3>();
}

void require_same_triangles(const Mesh& corresponding, const Mesh& mean, const std::string& who) {
  if (corresponding.triangles() != mean.triangles())
    throw InvalidInput(who + ": the two meshes have different triangles; both must come from one model");
}

/// For each face, whether its normal opposes the sum of the area vectors of the other faces at its corners.
std::vector<char> opposing_surroundings(const Mesh& mesh) {
  VertexMap<Vec3> around(mesh.vertex_count(), Vec3::Zero());
  for (FaceId f : mesh.faces())
    for (VertexId v : mesh.corners(f)) around[v] += area_vector(mesh.triangle(f));
  std::vector<char> opposing;
  opposing.reserve(mesh.face_count());
  for (FaceId f : mesh.faces()) {
    const Vec3 own = area_vector(mesh.triangle(f));
    Vec3 others = -3 * own;
    for (VertexId v : mesh.corners(f)) others += around[v];
    opposing.push_back(own.dot(others) < 0);
  }
  return opposing;
}

}  // namespace

SampledFlips sampled_flips(const Mesh& corresponding, const TriangleTree& input,
                           const SampledFlipsOptions& options) {
  SampledFlips flips;
  if (corresponding.face_count() == 0) return flips;
  const double margin = confirming_edges * mean_edge_length(corresponding);
  for (FaceId f : corresponding.faces()) {
    const auto t = corresponding.triangle(f);
    if (is_degenerate(t, options.least_height_mm)) {
      flips.degenerate.push_back(f);
      continue;
    }
    const Vec3 normal = area_vector(t), centroid = (t[0] + t[1] + t[2]) / 3;
    const ClosestPoint closest = input.closest(centroid);
    if (!closest.on.face.valid() || !opposes(normal, input.mesh(), closest.on.face)) continue;
    flips.plain.push_back(f);
    const double radius = std::sqrt(closest.squared_distance) + margin;
    if (opposes_all(normal, input.mesh(), input.faces_within(centroid, radius))) flips.confirmed.push_back(f);
  }
  return flips;
}

double single_precision_height(const Mesh& mesh) {
  double largest = 0;
  for (const Vec3& p : mesh.positions()) largest = std::max(largest, p.lpNorm<Eigen::Infinity>());
  return rounding_errors * (std::numeric_limits<float>::epsilon() / 2) * largest;
}

int opposing_mean(const Mesh& corresponding, const Mesh& mean) {
  require_same_triangles(corresponding, mean, "opposing_mean");
  const Mat3 rotation = rotation_onto(corresponding, mean);
  int count = 0;
  for (FaceId f : mean.faces())
    if ((rotation * area_vector(corresponding.triangle(f))).dot(area_vector(mean.triangle(f))) < 0) ++count;
  return count;
}

int folded_over(const Mesh& corresponding, const Mesh& mean) {
  require_same_triangles(corresponding, mean, "folded_over");
  const std::vector<char> now = opposing_surroundings(corresponding), before = opposing_surroundings(mean);
  int count = 0;
  for (std::size_t f = 0; f < now.size(); ++f)
    if (now[f] && !before[f]) ++count;
  return count;
}

}  // namespace foramen
