#include "synth/vertebra_features.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "synth/vertebra_surface.hpp"

namespace foramen::synth {
namespace {

// The laws of the features mean something only where the features are.
TEST(VertebraFeatures, LieOnTheTemplate) {
  const auto off = [](const Vec3& p) { return std::abs(vertebra_surface(p).value); };
  for (const int side : {1, -1})
    for (const RimPoint& at : endplate_rim(side, 16))
      EXPECT_LT(off(at.position), 3) << side << " " << at.angle;
  for (const Facet& facet : left_facets()) {
    EXPECT_LT(off(facet.centre), 1);
    EXPECT_GT(vertebra_surface(facet.centre).gradient.normalized().dot(facet.normal), 0.9);
  }
  EXPECT_LT(off(spinous_process().tip), 2.5);
  for (const Process& process : left_processes()) {
    EXPECT_LT(off(process.tip), 2.5);
    EXPECT_LT(vertebra_surface(process.base).value, 0);
  }
}

}  // namespace
}  // namespace foramen::synth
