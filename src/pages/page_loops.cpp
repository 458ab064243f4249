#include "pages/page_loops.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Eigenvalues>

#include "foramen/core/geometry.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "render/vertebra_scenes.hpp"
#include "sampling/lift_to_surface.hpp"

namespace foramen {
namespace {

Vec3 centroid(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

// The centroid of the solid that the surface encloses.
Vec3 volume_centroid(const Mesh& mesh) {
  Vec3 moment = Vec3::Zero();
  for (FaceId f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    moment += t[0].dot(t[1].cross(t[2])) / 24 * (t[0] + t[1] + t[2]);
  }
  return moment / signed_volume(mesh);
}

// A loop around the canal lies on a wall whose normals point to the middle of the loop. The normals along a
// loop around the bony ring point away from its middle.
bool faces_its_middle(const Mesh& mesh, const VertexMap<Vec3>& normals, const std::vector<SurfacePoint>& loop,
                      const std::vector<Vec3>& points) {
  const Vec3 middle = centroid(points);
  double inward = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto corners = mesh.corners(loop[i].face);
    Vec3 normal = Vec3::Zero();
    for (int k = 0; k < 3; ++k) normal += loop[i].barycentric[k] * normals[corners[k]];
    inward += normal.dot(middle - points[i]);
  }
  return inward > 0;
}

struct Canal {
  Vec3 middle, axis;  // the axis points to the head if the third coordinate does
};

std::optional<Canal> find_canal(const Mesh& mean, const std::array<std::vector<SurfacePoint>, 2>& loops) {
  const VertexMap<Vec3> normals = vertex_normals(mean);
  std::optional<Canal> canal;
  for (const auto& loop : loops) {
    std::vector<Vec3> points;
    points.reserve(loop.size());
    for (const SurfacePoint& p : loop) points.push_back(position(mean, p));
    if (!faces_its_middle(mean, normals, loop, points)) continue;
    if (canal) return std::nullopt;
    const Vec3 middle = centroid(points);
    Mat3 spread = Mat3::Zero();
    for (const Vec3& p : points) spread += (p - middle) * (p - middle).transpose();
    // The normal of the loop is the direction of least spread.
    const Vec3 axis = Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors().col(0);
    canal = Canal{middle, axis.z() < 0 ? Vec3(-axis) : axis};
  }
  return canal;
}

Vec3 orthogonal_part(const Vec3& v, const Vec3& unit) { return (v - v.dot(unit) * unit).normalized(); }

std::vector<PageView> principal_views(const Mesh& mean) {
  std::vector<PageView> views;
  for (const auto& [name, view] : {std::pair{"Shortest axis", View::along_shortest},
                                   {"Middle axis", View::along_middle},
                                   {"Longest axis", View::along_longest}}) {
    const Camera camera = view_of(mean.positions(), view, mean.positions());
    views.push_back({name, -camera.direction, camera.up});
  }
  return views;
}

}  // namespace

std::array<std::vector<SurfacePoint>, 2> loops_on_landmarks(const Atlas& atlas) {
  const LandmarkMesh& landmarks = atlas.landmarks;
  // Only the torus positions matter here, so the points in space are arbitrary.
  const Mesh mesh =
      build_mesh({std::vector<Vec3>(landmarks.turns.size(), Vec3::Zero()), landmarks.triangles});
  const TorusLocator locator(mesh, {atlas.map.lattice, VertexMap<Vec2>(landmarks.turns), landmarks.jumps});
  std::array<std::vector<SurfacePoint>, 2> loops;
  for (std::size_t k = 0; k < 2; ++k)
    for (VertexId v : atlas.loops[k]) loops[k].push_back(locator.locate(atlas.map.turns[v]));
  return loops;
}

std::vector<PageView> page_views(const Mesh& mean, const std::array<std::vector<SurfacePoint>, 2>& loops) {
  const std::optional<Canal> canal = find_canal(mean, loops);
  if (!canal) return principal_views(mean);
  const Vec3& head = canal->axis;
  // The body has most of the vertebra's volume and lies in front of the canal.
  const Vec3 front = orthogonal_part(volume_centroid(mean) - canal->middle, head);
  const Vec3 side = head.cross(front);
  const Vec3 oblique = (0.75 * head + 0.75 * side - front).normalized();
  return {{"Oblique", oblique, orthogonal_part(head, oblique)},
          {"Along the canal", -head, front},
          {"Side", side, head},
          {"Back", -front, head},
          {"Front", front, head}};
}

}  // namespace foramen
