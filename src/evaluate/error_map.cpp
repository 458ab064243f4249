#include "evaluate/error_map.hpp"

#include <algorithm>
#include <cmath>

namespace foramen {
namespace {

std::vector<int> indices(const std::vector<FaceId>& faces) {
  std::vector<int> out;
  out.reserve(faces.size());
  for (FaceId f : faces) out.push_back(f.index);
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

ErrorMap error_map(const TriangleTree& corresponding, const TriangleTree& input, const SampledFlips& flips) {
  const Mesh& landmarks = corresponding.mesh();
  ErrorMap map{std::vector<double>(landmarks.vertex_count(), 0.0), indices(flips.plain),
               indices(flips.confirmed)};
  const auto count = [&](VertexId landmark, const ClosestPoint& closest) {
    double& largest = map.landmark_mm[landmark.index];
    largest = std::max(largest, std::sqrt(closest.squared_distance));
  };
  for (const Vec3& p : input.mesh().positions()) {
    const ClosestPoint closest = corresponding.closest(p);
    int corner = 0;
    closest.on.barycentric.maxCoeff(&corner);
    count(landmarks.corners(closest.on.face)[corner], closest);
  }
  for (VertexId v : landmarks.vertices()) count(v, input.closest(landmarks.position(v)));
  for (EdgeId e : landmarks.edges()) {
    const HalfedgeId h = landmarks.halfedge(e);
    const VertexId a = landmarks.from(h), b = landmarks.to(h);
    const ClosestPoint closest = input.closest((landmarks.position(a) + landmarks.position(b)) / 2);
    count(a, closest);
    count(b, closest);
  }
  for (FaceId f : landmarks.faces()) {
    const auto t = landmarks.triangle(f);
    const ClosestPoint closest = input.closest((t[0] + t[1] + t[2]) / 3);
    for (VertexId corner : landmarks.corners(f)) count(corner, closest);
  }
  return map;
}

}  // namespace foramen
