#include "foramen/core/units.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace foramen {
namespace {

constexpr std::array all_units{LengthUnit::millimetre, LengthUnit::centimetre, LengthUnit::metre,
                               LengthUnit::micrometre};

TEST(Units, AreFactorsOfAMillimetre) {
  EXPECT_EQ(millimetres_per(LengthUnit::millimetre), 1);
  EXPECT_EQ(millimetres_per(LengthUnit::centimetre), 10);
  EXPECT_EQ(millimetres_per(LengthUnit::metre), 1000);
  EXPECT_EQ(millimetres_per(LengthUnit::micrometre), 0.001);
}

TEST(Units, AreFoundByTheirNames) {
  for (const LengthUnit unit : all_units) EXPECT_EQ(length_unit(name(unit)), unit);
  EXPECT_EQ(name(LengthUnit::micrometre), "um");
  for (const char* none : {"", "MM", "mm ", "km", "inch"}) EXPECT_EQ(length_unit(none), std::nullopt) << none;
}

TEST(Units, LikelyUnitOfAVertebra) {
  EXPECT_EQ(likely_unit(100), std::nullopt);
  EXPECT_EQ(likely_unit(0.1), LengthUnit::metre);
  EXPECT_EQ(likely_unit(9), LengthUnit::centimetre);
  EXPECT_EQ(likely_unit(90000), LengthUnit::micrometre);
  EXPECT_EQ(likely_unit(1e9), std::nullopt);
  EXPECT_EQ(likely_unit(0), std::nullopt);
  EXPECT_EQ(likely_unit(std::nan("")), std::nullopt);
}

// The range includes 20 and 250 mm. If two units are possible (20 to 25), the result is millimetres.
TEST(Units, TheLikelyUnitMakesAVertebraOfIt) {
  for (double diagonal = 1e-3; diagonal < 1e7; diagonal *= 1.01) {
    SCOPED_TRACE(diagonal);
    const auto fits = [&](LengthUnit unit) {
      const double mm = diagonal * millimetres_per(unit);
      return mm >= smallest_diagonal_mm && mm <= largest_diagonal_mm;
    };
    const auto likely = likely_unit(diagonal);
    if (likely) {
      EXPECT_TRUE(fits(*likely));
      EXPECT_NE(*likely, LengthUnit::millimetre);
      EXPECT_FALSE(fits(LengthUnit::millimetre));
    } else if (!fits(LengthUnit::millimetre)) {
      for (const LengthUnit unit : all_units) EXPECT_FALSE(fits(unit)) << name(unit);
    }
  }
  EXPECT_EQ(likely_unit(250), std::nullopt);
  EXPECT_EQ(likely_unit(2), LengthUnit::centimetre);
  EXPECT_EQ(likely_unit(0.25), LengthUnit::metre);
  EXPECT_EQ(likely_unit(0.251), std::nullopt);
}

TEST(InputUnit, IsCertainOnlyIfMillimetresAreGiven) {
  EXPECT_EQ(input_unit(std::nullopt), InputUnit(LengthUnit::millimetre, false));
  EXPECT_EQ(input_unit(LengthUnit::millimetre), InputUnit(LengthUnit::millimetre, true));
  EXPECT_EQ(input_unit(LengthUnit::metre), InputUnit(LengthUnit::metre, false));
}

}  // namespace
}  // namespace foramen
