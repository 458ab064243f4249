// An archived registration is restored completely. Every number has a different value, so that the tests
// detect numbers that are missing or exchanged.
#include "correspond/registered_archive.hpp"
#include "correspond/register_shape.hpp"
#include "foramen/correspond/registration_frame.hpp"

#include <gtest/gtest.h>

#include "foramen/core/geometry.hpp"
#include "parameterize/mapped_torus.hpp"

namespace foramen {
namespace {

template <class Value>
Value there_and_back(const Value& value) {
  return from_bytes<Value>(to_bytes(value));
}

ShapeMap some_shape_map() {
  const testing::MappedTorus torus = testing::mapped_bumpy_torus(12, 9, 2);
  ShapeMap map;
  map.map = torus.map;
  map.map.lattice(0, 1) = 0.25;
  map.certificate = {11, 12, 13.5, 14.5, 15.5, true};
  map.iterations = 16;
  map.initial_energy = 17.5;
  map.final_energy = 18.5;
  map.distortion = 19.5;
  return map;
}

void expect_same(const ShapeMap& a, const ShapeMap& b) {
  EXPECT_EQ(a.map.lattice, b.map.lattice);
  EXPECT_EQ(a.map.turns, b.map.turns);
  EXPECT_EQ(a.map.jumps, b.map.jumps);
  EXPECT_EQ(a.certificate.triangles, b.certificate.triangles);
  EXPECT_EQ(a.certificate.flipped, b.certificate.flipped);
  EXPECT_EQ(a.certificate.smallest_area_ratio, b.certificate.smallest_area_ratio);
  EXPECT_EQ(a.certificate.largest_area_ratio, b.certificate.largest_area_ratio);
  EXPECT_EQ(a.certificate.degree, b.certificate.degree);
  EXPECT_EQ(a.certificate.periods_consistent, b.certificate.periods_consistent);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_EQ(a.initial_energy, b.initial_energy);
  EXPECT_EQ(a.final_energy, b.final_energy);
  EXPECT_EQ(a.distortion, b.distortion);
}

TEST(RegisteredArchive, AShapeMapComesBack) {
  const ShapeMap map = some_shape_map();
  expect_same(there_and_back(map), map);
}

TEST(RegisteredArchive, ARegisteredShapeComesBack) {
  RegisteredShape shape;
  shape.shape_map = some_shape_map();
  shape.alignment.transform.translate(Vec3(1, 2, 3));
  shape.homology << 1, 2, 3, 4;
  shape.seifert << 5, 6, 7, 8;
  shape.agreement = Vec2(0.9, 0.8);
  const RegisteredShape again = there_and_back(shape);
  expect_same(again.shape_map, shape.shape_map);
  EXPECT_EQ(again.alignment.transform.matrix(), shape.alignment.transform.matrix());
  EXPECT_EQ(again.homology, shape.homology);
  EXPECT_EQ(again.seifert, shape.seifert);
  EXPECT_EQ(again.agreement, shape.agreement);
}

TEST(RegisteredArchive, AReferenceComesBackWithItsLoops) {
  Reference reference;
  LoopSystem& loops = reference.loops.loops;
  const testing::MappedTorus torus = testing::mapped_bumpy_torus(12, 9, 2);
  reference.loops.mesh = torus.mesh;
  reference.loops.seifert << 1, 0, -2, 3;
  loops = greedy_loops(torus.mesh, VertexId(5), edge_lengths(torus.mesh));
  reference.shape_map = some_shape_map();
  const Reference again = there_and_back(reference);
  EXPECT_EQ(again.mesh().soup().points, torus.mesh.soup().points);
  EXPECT_EQ(again.mesh().triangles(), torus.mesh.triangles());
  EXPECT_EQ(again.loops.loops.basepoint, loops.basepoint);
  EXPECT_EQ(again.loops.loops.loops, loops.loops);
  EXPECT_EQ(again.loops.loops.generators, loops.generators);
  EXPECT_EQ(again.loops.loops.tree_parent, loops.tree_parent);
  EXPECT_EQ(again.loops.loops.length, loops.length);
  EXPECT_EQ(again.loops.seifert, reference.loops.seifert);
  expect_same(again.shape_map, reference.shape_map);
}

}  // namespace
}  // namespace foramen
