// Rough cohorts: what was said about their surfaces and their truth.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foramen/core/geometry.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "foramen/synth/synth_cohort.hpp"
#include "spatial/flips.hpp"
#include "spatial/self_intersections.hpp"

namespace foramen {
namespace {

SynthOptions rough(int shapes, std::uint64_t seed = 201) {
  return {.shapes = shapes, .seed = seed, .deformation = SynthDeformation::rough, .vertices = 3000};
}

const std::vector<SynthShape>& rough_shapes() {
  static const auto shapes = synth_cohort(rough(4), RunContext());
  return shapes;
}

TEST(RoughCohort, TruthMeshesNeitherFoldNorIntersectThemselves) {
  const Mesh still = build_mesh(synth_cohort({.shapes = 1, .amplitude_mm = 0}, RunContext())[0].truth);
  for (const SynthShape& s : rough_shapes()) {
    const Mesh truth = build_mesh(s.truth);
    EXPECT_EQ(folded_over(truth, still), 0);
    EXPECT_TRUE(self_intersections(TriangleTree(truth)).empty());
    EXPECT_EQ(s.truth.triangles, rough_shapes()[0].truth.triangles);
  }
}

TEST(RoughCohort, SurfacesAreEmbeddedTori) {
  for (const SynthShape& s : rough_shapes()) {
    const Mesh surface = build_mesh(s.surface);
    EXPECT_TRUE(surface.is_closed());
    EXPECT_EQ(surface.euler_characteristic(), 0);
    EXPECT_GT(signed_volume(surface), 0);
    EXPECT_TRUE(self_intersections(TriangleTree(surface)).empty());
  }
}

TEST(RoughCohort, SurfacesHaveDifferentDensities) {
  const SynthOptions options = rough(4);
  std::vector<double> counts;
  for (const SynthShape& s : rough_shapes()) counts.push_back(static_cast<double>(s.surface.points.size()));
  EXPECT_GT(std::ranges::max(counts), 1.2 * std::ranges::min(counts));
  EXPECT_GE(std::ranges::min(counts), 0.6 * 0.95 * options.vertices);
  EXPECT_LE(std::ranges::max(counts), 1.6 * 1.05 * options.vertices);
}

// The noise alone parts the vertices of a surface from the truth: its mean absolute value is 0.12 mm times
// sqrt(2 / pi), to which the chords of the truth's triangles add a little.
TEST(RoughCohort, SurfacesLieOnTheTruthButForTheNoise) {
  for (const SynthShape& s : rough_shapes()) {
    const Mesh truth = build_mesh(s.truth);
    const TriangleTree tree(truth);
    double sum = 0, largest = 0;
    for (const Vec3& p : s.surface.points) {
      const double distance = std::sqrt(tree.closest(p).squared_distance);
      sum += distance;
      largest = std::max(largest, distance);
    }
    const double mean = sum / static_cast<double>(s.surface.points.size());
    EXPECT_GT(mean, 0.08);
    EXPECT_LT(mean, 0.12);
    EXPECT_LT(largest, 1.0);
  }
}

TEST(RoughCohort, ItemsDependNeitherOnThreadsNorOnTheirNumber) {
  const auto one = synth_cohort(rough(1), RunContext(1));
  const auto two = synth_cohort(rough(2), RunContext(2));
  EXPECT_EQ(one[0].surface.points, two[0].surface.points);
  EXPECT_EQ(one[0].surface.triangles, two[0].surface.triangles);
  EXPECT_EQ(one[0].truth.points, two[0].truth.points);
}

TEST(RoughCohort, ShapesDifferAlsoWithoutTheSmoothDeformation) {
  SynthOptions options = rough(2);
  options.amplitude_mm = 0;
  const auto shapes = synth_cohort(options, RunContext());
  double change = 0;
  const auto edge = [](const TriangleSoup& soup, std::size_t f) {
    const auto& t = soup.triangles[f];
    return (soup.points[t[0]] - soup.points[t[1]]).norm();
  };
  for (std::size_t f = 0; f < shapes[0].truth.triangles.size(); ++f)
    change = std::max(change, std::abs(edge(shapes[0].truth, f) / edge(shapes[1].truth, f) - 1));
  EXPECT_GT(change, 0.2);
}

}  // namespace
}  // namespace foramen
