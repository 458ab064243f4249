#include "render/colour_scale.hpp"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render/in_picture.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

double luminance(const Colour& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

TEST(ColourScale, GetsDarkerAllTheWay) {
  const ColourScale scale{2.5, "mm"};
  for (int i = 0; i < 50; ++i)
    EXPECT_GT(luminance(colour_of(scale, 0.05 * i)), luminance(colour_of(scale, 0.05 * (i + 1)))) << i;
}

TEST(ColourScale, WhatIsOutsideHasTheColoursOfTheEnds) {
  const ColourScale scale{2, ""};
  EXPECT_EQ(colour_of(scale, -1), colour_of(scale, 0));
  EXPECT_EQ(colour_of(scale, 7), colour_of(scale, 2));
  EXPECT_NE(colour_of(scale, 1.9), colour_of(scale, 2));
}

TEST(RoundedUp, IsARoundNumberNotBelowAndLittleAbove) {
  for (double value : {0.0011, 0.1, 0.11, 0.99, 1.0, 3.7, 7.9, 8.1, 123.0}) {
    EXPECT_GE(rounded_up(value), value);
    EXPECT_LE(rounded_up(value), 1.51 * value);
  }
  EXPECT_EQ(rounded_up(0), 1);
}

TEST(ScaleFor, SingleValuesDoNotDecide) {
  std::vector<double> values(1000, 0.37);
  values[3] = 50;
  EXPECT_EQ(scale_for(values, "mm").high, 0.4);
  EXPECT_EQ(scale_for(values, "mm", 0).high, 50);
  EXPECT_EQ(scale_for(std::vector<double>{0.0, 0.0}, "mm").high, 1);
}

TEST(ColouredSurface, APointHasTheColourOfItsValue) {
  const TriangleSoup soup = testing::torus_soup(12, 8);
  std::vector<double> values(soup.points.size(), 0.0);
  values[5] = 3;
  const ColourScale scale{3, "mm"};
  const SceneSurface surface = coloured_surface(soup, values, scale);
  ASSERT_EQ(surface.vertex_colours.size(), soup.points.size());
  EXPECT_EQ(surface.vertex_colours[5], colour_of(scale, 3));
  EXPECT_EQ(surface.vertex_colours[6], colour_of(scale, 0));
}

// The colour of the bar at a tick is that of the number beside it, and the picture contains the whole bar.
TEST(ColourBar, ATickStandsBesideItsColour) {
  const ColourScale scale{0.5, "mm"};
  const Scene bar = colour_bar(scale, 40);
  std::vector<std::string> written;
  for (const SceneText& text : bar.texts) {
    written.push_back(text.text);
    const double value = std::stod(text.text);
    for (std::size_t i = 0; i < bar.surfaces[0].soup.points.size(); ++i)
      if (std::abs(bar.surfaces[0].soup.points[i].z() - text.at.z()) < 1e-9) {
        EXPECT_EQ(bar.surfaces[0].vertex_colours[i], colour_of(scale, value));
      }
    EXPECT_LT(std::abs(testing::in_picture(bar.camera, text.at).x()), bar.camera.width_mm / 2);
    EXPECT_LT(std::abs(testing::in_picture(bar.camera, text.at).y()), bar.camera.height_mm / 2);
  }
  EXPECT_THAT(written, ::testing::ElementsAre("0", "0.25", "0.5 mm"));
  EXPECT_EQ(bar.camera.height_mm, 40);
}

}  // namespace
}  // namespace foramen
