#include "synth/vertebra_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "foramen/core/rng.hpp"

namespace foramen {
namespace {

Vec3 random_point(Rng& rng) {
  const BoundingBox box = vertebra_bounds();
  Vec3 p;
  for (int k = 0; k < 3; ++k) p[k] = rng.uniform(box.low[k], box.high[k]);
  return p;
}

const Mesh& template_mesh() {
  static const Mesh mesh =
      build_mesh(isosurface(vertebra_surface, {.bounds = vertebra_bounds(), .spacing_mm = 2.0}));
  return mesh;
}

bool inside(const Vec3& p) { return vertebra_surface(p).value < 0; }

TEST(VertebraSurface, TheGradientIsThatOfTheValueNearTheSurface) {
  constexpr double h = 1e-5;
  for (int i = 0; i < template_mesh().vertex_count(); i += 20) {
    const Vec3 p = template_mesh().position(VertexId(i));
    const Vec3 gradient = vertebra_surface(p).gradient;
    Vec3 difference;
    for (int k = 0; k < 3; ++k)
      difference[k] =
          (vertebra_surface(p + h * Vec3::Unit(k)).value - vertebra_surface(p - h * Vec3::Unit(k)).value) /
          (2 * h);
    EXPECT_LT((difference - gradient).norm(), 1e-3) << p.transpose();
    EXPECT_GT(gradient.norm(), 0.3) << p.transpose();
    EXPECT_LT(gradient.norm(), 3.0) << p.transpose();
  }
}

TEST(VertebraSurface, IsLeftRightSymmetric) {
  Rng rng(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = random_point(rng);
    EXPECT_NEAR(vertebra_surface(p).value, vertebra_surface({-p.x(), p.y(), p.z()}).value, 1e-9);
  }
}

TEST(VertebraSurface, IsOneClosedSurfaceOfGenusOneWithTheSizeOfALumbarVertebra) {
  const Mesh& mesh = template_mesh();
  EXPECT_TRUE(mesh.is_closed());
  EXPECT_EQ(mesh.euler_characteristic(), 0);
  // Real L1-L5: area 10900 to 18600 mm^2, volume 45000 to 82000 mm^3, about 53-116 x 75-98 x 44-57 mm.
  EXPECT_NEAR(total_area(mesh), 13000, 1000);
  EXPECT_NEAR(signed_volume(mesh), 48500, 3000);
  const BoundingBox box = bounding_box(mesh.positions());
  EXPECT_NEAR(box.high.x() - box.low.x(), 87, 3);
  EXPECT_NEAR(box.high.y() - box.low.y(), 83, 3);
  EXPECT_NEAR(box.high.z() - box.low.z(), 51, 3);
}

TEST(VertebraSurface, FitsWellIntoItsBounds) {
  const BoundingBox bounds = vertebra_bounds(), box = bounding_box(template_mesh().positions());
  EXPECT_GT((box.low - bounds.low).minCoeff(), 3);
  EXPECT_GT((bounds.high - box.high).minCoeff(), 3);
}

TEST(VertebraSurface, HasItsParts) {
  EXPECT_TRUE(inside({0, 0, 0})) << "body";
  EXPECT_FALSE(inside({0, 0, 12.5})) << "concave endplate above";
  EXPECT_FALSE(inside({0, 0, -12.5})) << "concave endplate below";
  EXPECT_TRUE(inside({21.8, 0, 10})) << "rim";
  EXPECT_FALSE(inside({21.8, 0, 0})) << "waist";
  for (double z = -40; z <= 40; z += 0.5) EXPECT_FALSE(inside({0, 24.5, z})) << "canal at z " << z;
  EXPECT_TRUE(inside({0, 55, -9})) << "spinous process";
  for (double side : {-1.0, 1.0}) {
    EXPECT_TRUE(inside({side * 15, 20, 5})) << "pedicle";
    EXPECT_FALSE(inside({side * 15, 23, -8})) << "notch below the pedicle";
    EXPECT_TRUE(inside({side * 7, 34.5, -7})) << "lamina";
    EXPECT_TRUE(inside({side * 18, 34.5, 16})) << "superior articular process";
    EXPECT_TRUE(inside({side * 12.5, 36, -25})) << "inferior articular process";
    EXPECT_TRUE(inside({side * 38, 34.5, 4.9})) << "transverse process";
  }
  EXPECT_FALSE(inside({0, 34, 8})) << "gap between the superior processes";
  EXPECT_FALSE(inside({0, 37, -22})) << "gap between the inferior processes";
}

// The free width of the canal at its middle, measured by stepping outwards.
double free_half_width(const Vec3& from, const Vec3& direction) {
  double t = 0;
  while (!inside(from + t * direction)) t += 0.05;
  return t;
}

TEST(VertebraSurface, TheCanalHasTheWidthAndDepthOfARealOne) {
  const Vec3 middle(0, 24.5, 5);
  EXPECT_NEAR(2 * free_half_width(middle, Vec3::UnitX()), 24, 2.5);
  const Vec3 low(0, 24.5, -5);
  EXPECT_NEAR(free_half_width(low, Vec3::UnitY()) + free_half_width(low, -Vec3::UnitY()), 18, 2.5);
}

}  // namespace
}  // namespace foramen
