#include "foramen/correspond/correspond.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "support/meshes.hpp"
#include "support/torus_family.hpp"

namespace foramen {
namespace {

using ::testing::ElementsAre;
using testing::family;
using ::testing::HasSubstr;

const CorrespondOptions only_aligned{.method = Method::icp};

TEST(Correspond, TooFewShapesAreRefused) {
  std::vector<Shape> shapes = family();
  shapes.resize(2);
  EXPECT_THROW(correspond(shapes, only_aligned, RunContext(1)), TooFewShapes);
}

TEST(Correspond, AnUnknownReferenceIsRefused) {
  CorrespondOptions options = only_aligned;
  options.reference = "nobody";
  EXPECT_THROW(correspond(family(), options, RunContext(1)), InvalidInput);
}

TEST(Correspond, AnOptionOutOfItsRangeIsRefused) {
  CorrespondOptions options = only_aligned;
  options.group.lambda = 0;
  EXPECT_THROW(correspond(family(), options, RunContext(1)), InvalidInput);
}

// A surface of genus 0 has no torus map. The other shapes must still be used.
Shape sphere() {
  TriangleSoup octahedron{
      {{20, 0, 0}, {-20, 0, 0}, {0, 20, 0}, {0, -20, 0}, {0, 0, 20}, {0, 0, -20}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  return {"sphere", build_mesh(std::move(octahedron))};
}

TEST(Correspond, AShapeThatFailsIsLeftOutWithTheReasonAndTheRestGoOn) {
  std::vector<Shape> shapes = family();
  shapes.insert(shapes.begin() + 1, sphere());
  const Correspondence found =
      correspond(shapes, {.objective = Objective::neighbours, .reference = "s0"}, RunContext(2));
  ASSERT_EQ(found.registration.failed.size(), 1u);
  EXPECT_EQ(found.registration.failed[0].name, "sphere");
  EXPECT_FALSE(found.registration.failed[0].reason.text.empty());
  std::vector<std::string> names;
  for (const ShapeRegistration& shape : found.registration.shapes) names.push_back(shape.name);
  EXPECT_THAT(names, ElementsAre("s0", "s1", "s2", "s3"));
  EXPECT_EQ(found.registration.reference, 0);
  for (std::size_t i = 0; i < found.maps.size(); ++i)
    EXPECT_EQ(found.maps[i].turns.size(), shape_named(shapes, names[i]).mesh.vertex_count());
}

// Puts a needle of ever smaller triangles on a triangle of the surface. The surface is valid, but its
// harmonic map shrinks the tip of the needle to nothing.
TriangleSoup with_needle(TriangleSoup soup) {
  const std::array<int, 3> base = soup.triangles.back();
  soup.triangles.pop_back();
  std::array<Vec3, 3> corners;
  for (std::size_t m = 0; m < 3; ++m) corners[m] = soup.points[base[m]];
  const Vec3 step = 0.01 * unit_normal(corners), centre = (corners[0] + corners[1] + corners[2]) / 3;
  constexpr int rings = 60;
  std::array<int, 3> below = base;
  for (int r = 1; r <= rings; ++r) {
    std::array<int, 3> ring{};
    for (std::size_t m = 0; m < 3; ++m) {
      ring[m] = static_cast<int>(soup.points.size());
      soup.points.push_back(centre + 0.5 * (corners[m] - centre) + r * step);
    }
    for (std::size_t m = 0; m < 3; ++m) {
      const std::size_t n = (m + 1) % 3;
      soup.triangles.push_back({below[m], below[n], ring[n]});
      soup.triangles.push_back({below[m], ring[n], ring[m]});
    }
    below = ring;
  }
  soup.triangles.push_back(below);
  return soup;
}

TEST(Correspond, AnOrdinaryShapeThatHasNoMapIsNotTheReference) {
  std::vector<Shape> shapes = family();
  const int first = rank_references(shapes).front();
  Shape& ragged = shapes[first];
  ragged.mesh = build_mesh(with_needle(ragged.mesh.soup()));
  ASSERT_EQ(rank_references(shapes).front(), first) << "the needle weighs nothing";
  const CohortRegistration found = correspond(shapes, only_aligned, RunContext(2)).registration;
  ASSERT_EQ(found.refused_references.size(), 1u);
  EXPECT_EQ(found.refused_references[0].name, ragged.name);
  EXPECT_GE(found.shapes.size(), 3u);
  EXPECT_NE(found.shapes[found.reference].name, ragged.name);
}

TEST(RankReferences, BeginsWithTheShapeOfMedianSize) {
  std::vector<Shape> shapes;
  for (double size : {1.3, 0.8, 1.0, 1.1, 0.5}) {
    TriangleSoup soup = testing::torus_soup(16, 10);
    for (Vec3& p : soup.points) p *= size;
    shapes.push_back({"x", build_mesh(soup)});
  }
  EXPECT_THAT(rank_references(shapes), ElementsAre(2, 3, 1, 0, 4));
}

TEST(RankReferences, EndsWithVeryLargeShapes) {
  const Shape ordinary{"ordinary", build_mesh(testing::torus_soup(16, 10))},
      large{"large", build_mesh(testing::torus_soup(400, 260))};
  const std::vector<Shape> shapes{large, ordinary, large};
  EXPECT_THAT(rank_references(shapes), ElementsAre(1, 0, 2));
}

}  // namespace
}  // namespace foramen
