#include "foramen/spatial/surface_distance.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "spatial/percentile.hpp"

namespace foramen {
namespace {

// Barycentric coordinates of a point that is uniformly distributed in a triangle.
Vec3 random_barycentric(Rng& rng) {
  const double s = std::sqrt(rng.uniform()), t = rng.uniform();
  return {1 - s, s * (1 - t), s * t};
}

std::vector<double> distances(const Mesh& from, std::span<const SurfacePoint> samples,
                              const TriangleTree& to) {
  std::vector<double> result;
  result.reserve(samples.size());
  for (const SurfacePoint& p : samples)
    result.push_back(std::sqrt(to.closest(position(from, p)).squared_distance));
  return result;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Returns the maximum of `largest` and the distances of all vertices of `from`. For most vertices the cheap
// test any_within() shows that they are nearer than the maximum so far.
double raised_by_vertices(const Mesh& from, const TriangleTree& to, double largest) {
  for (const Vec3& p : from.positions())
    if (!to.any_within(p, largest)) largest = std::max(largest, std::sqrt(to.closest(p).squared_distance));
  return largest;
}

}  // namespace

std::vector<SurfacePoint> sample_surface(const Mesh& mesh, int count, const Rng& rng) {
  if (count < 0)
    throw InvalidInput("sample_surface: " + std::to_string(count) + " points asked for; give 0 or more");
  std::vector<double> area_up_to;
  area_up_to.reserve(mesh.face_count());
  double total = 0;
  for (FaceId f : mesh.faces()) area_up_to.push_back(total += area(mesh.triangle(f)));
  if (!(total > 0))
    throw InvalidInput("sample_surface: the surface has no area; its points may all coincide");
  Rng draws = rng;
  std::vector<SurfacePoint> points;
  points.reserve(count);
  std::size_t face = 0;
  for (int i = 0; i < count; ++i) {
    const double target = total * ((i + draws.uniform()) / count);
    // Takes the first face whose accumulated area is strictly above the target, so a face of zero area is
    // never taken. Rounding can put the target above the accumulated area of all faces.
    while (face < area_up_to.size() && area_up_to[face] <= target) ++face;
    if (face == area_up_to.size())
      face = static_cast<std::size_t>(std::lower_bound(area_up_to.begin(), area_up_to.end(), total) -
                                      area_up_to.begin());
    points.push_back({FaceId(static_cast<int>(face)), random_barycentric(draws)});
  }
  return points;
}

SurfaceDistance surface_distance(const TriangleTree& a, std::span<const SurfacePoint> samples_of_a,
                                 const TriangleTree& b, std::span<const SurfacePoint> samples_of_b) {
  if (samples_of_a.empty() || samples_of_b.empty())
    throw InvalidInput("surface_distance: needs at least one sample a side");
  std::vector<double> all = distances(a.mesh(), samples_of_a, b);
  const std::vector<double> back = distances(b.mesh(), samples_of_b, a);
  SurfaceDistance result;
  result.mean = 0.5 * (mean(all) + mean(back));
  all.insert(all.end(), back.begin(), back.end());
  const double largest_sample = *std::max_element(all.begin(), all.end());
  result.hausdorff = raised_by_vertices(b.mesh(), a, raised_by_vertices(a.mesh(), b, largest_sample));
  result.p95 = detail::percentile_95(std::move(all));
  return result;
}

SurfaceDistance surface_distance(const TriangleTree& a, const TriangleTree& b,
                                 const SurfaceDistanceOptions& options) {
  // Both surfaces are sampled with the same random stream, so the result is symmetric in the arguments.
  const Rng rng(options.seed);
  return surface_distance(a, sample_surface(a.mesh(), options.samples, rng), b,
                          sample_surface(b.mesh(), options.samples, rng));
}

}  // namespace foramen
