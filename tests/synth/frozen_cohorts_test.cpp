// Published figures identify cohorts by their seed alone, so these cohorts must not change.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <ostream>
#include <string>

#include "foramen/synth/synth_cohort.hpp"

namespace foramen {
namespace {

// Coordinates are rounded to this resolution, because the last bits of sin, cos and exp differ between
// machines.
constexpr double resolution_mm = 1e-3;

/// FNV-1a over 64-bit numbers, lowest byte first.
class Checksum {
 public:
  void add(std::int64_t number) {
    for (int shift = 0; shift < 64; shift += 8) {
      state_ ^= (static_cast<std::uint64_t>(number) >> shift) & 0xff;
      state_ *= 0x100000001b3;
    }
  }
  void add(const TriangleSoup& soup) {
    add(std::ssize(soup.points));
    add(std::ssize(soup.triangles));
    for (const auto& triangle : soup.triangles)
      for (const int corner : triangle) add(corner);
    for (const Vec3& p : soup.points)
      for (const double coordinate : p) add(std::llround(coordinate / resolution_mm));
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325;
};

// A shape does not depend on the number of shapes (another test checks this), so checking the first few is
// enough.
constexpr int checked = 4;

struct FrozenCohort {
  std::uint64_t seed, surfaces, truth;
};
void PrintTo(const FrozenCohort& cohort, std::ostream* out) { *out << "seed " << cohort.seed; }

void expect_as_it_was(const FrozenCohort& expected, const SynthOptions& options) {
  Checksum surfaces, truth;
  for (const SynthShape& shape : synth_cohort(options, RunContext())) {
    surfaces.add(shape.surface);
    truth.add(shape.truth);
  }
  EXPECT_EQ(surfaces.value(), expected.surfaces) << std::hex << "0x" << surfaces.value();
  EXPECT_EQ(truth.value(), expected.truth) << std::hex << "0x" << truth.value();
}

class FrozenCohorts : public ::testing::TestWithParam<FrozenCohort> {};

TEST_P(FrozenCohorts, AreWhatTheyWere) {
  expect_as_it_was(GetParam(), {.shapes = checked, .seed = GetParam().seed});
}

INSTANTIATE_TEST_SUITE_P(Seed, FrozenCohorts,
                         ::testing::Values(FrozenCohort{101, 0xf4a051c0d347e569, 0x82688d3c34fbfb1d},
                                           FrozenCohort{102, 0x47b4922cb59f409f, 0x1d0c842aaea8c82d},
                                           FrozenCohort{103, 0x934d04e3d0070a46, 0xa148f8183574ad04},
                                           FrozenCohort{104, 0x244c148192164f0f, 0x64f8511a7b8048b0},
                                           FrozenCohort{105, 0x7265c8b4be7c6520, 0x32e57966628dd6cf}),
                         [](const auto& test) { return std::to_string(test.param.seed); });

class FrozenRoughCohorts : public ::testing::TestWithParam<FrozenCohort> {};

// The calibration of rough cohorts in docs/results.md holds for these shapes of about 3000 vertices.
TEST_P(FrozenRoughCohorts, AreWhatTheyWere) {
  SynthOptions options{.shapes = checked, .seed = GetParam().seed, .deformation = SynthDeformation::rough};
  options.vertices = 3000;
  expect_as_it_was(GetParam(), options);
}

INSTANTIATE_TEST_SUITE_P(Seed, FrozenRoughCohorts,
                         ::testing::Values(FrozenCohort{201, 0xc0e851453184756c, 0x528106655a9f92b5},
                                           FrozenCohort{202, 0xe97b80f2595d953c, 0x3d64805729f4cfe1},
                                           FrozenCohort{203, 0x3a244cc3e942bb73, 0x75f6e3783d23288f},
                                           FrozenCohort{204, 0xd25bbe6e9139a6de, 0x228d9a76b43dc745},
                                           FrozenCohort{205, 0x6eb78f0db89cb89, 0x43ff423cd9517803},
                                           FrozenCohort{206, 0xb6d5a8ef791a840b, 0x2f10adb2f4022e57}),
                         [](const auto& test) { return std::to_string(test.param.seed); });

TEST(SynthOptions, DefaultsAreFrozen) {
  const SynthOptions defaults;
  EXPECT_EQ(defaults.deformation, SynthDeformation::smooth);
  EXPECT_EQ(defaults.shapes, 14);
  EXPECT_EQ(defaults.modes, 4);
  EXPECT_EQ(defaults.amplitude_mm, 2.1);
  EXPECT_EQ(defaults.correlation_mm, 40.0);
  EXPECT_EQ(defaults.vertices, 10000);
}

}  // namespace
}  // namespace foramen
