#include "render/render_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "render/vertebra_scenes.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

Scene torus_scene() {
  Scene scene;
  scene.surfaces.emplace_back().soup = testing::torus_soup(30, 16);
  scene.camera = frame(scene.surfaces[0].soup.points, {0, 0, -1}, {0, 1, 0});
  return scene;
}

TEST(RenderPng, WithoutADisplayItSaysSo) {
  if (can_render()) GTEST_SKIP() << "there is a display";
  try {
    render_png({{torus_scene()}}, 64);
    FAIL() << "a picture without a display";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(),
                ::testing::AnyOf(::testing::HasSubstr("xvfb-run"), ::testing::HasSubstr("libvtk9-dev")));
  }
}

// Bytes 16 to 23 of a PNG are its width and height.
int big_endian(const std::string& bytes, std::size_t at) {
  int value = 0;
  for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes.at(at + k));
  return value;
}

TEST(RenderPng, ARowFillsTheWidthAndTheSameSceneGivesTheSameBytes) {
  if (!can_render()) GTEST_SKIP() << "needs VTK and a display";
  Scene wide = torus_scene();
  wide.camera.width_mm = 3 * wide.camera.height_mm;
  const std::vector<std::vector<Scene>> rows{{torus_scene(), wide}, {wide}};
  const std::string png = render_png(rows, 240);
  EXPECT_EQ(big_endian(png, 16), 240);
  EXPECT_EQ(big_endian(png, 20), 60 + 80);
  EXPECT_TRUE(render_png(rows, 240) == png);
}

TEST(RenderPng, TextIsDrawn) {
  if (!can_render()) GTEST_SKIP() << "needs VTK and a display";
  Scene scene = torus_scene();
  const std::string without = render_png({{scene}}, 120);
  scene.texts.push_back({"0.5 mm", scene.camera.centre, scene.camera.height_mm / 8});
  const std::string with = render_png({{scene}}, 120);
  EXPECT_FALSE(with == without);
  scene.texts[0].at += 1000 * scene.camera.up;
  EXPECT_TRUE(render_png({{scene}}, 120) == without);
}

}  // namespace
}  // namespace foramen
