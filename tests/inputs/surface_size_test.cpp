#include "inputs/surface_size.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/meshes.hpp"
#include "support/messages.hpp"

namespace foramen {
namespace {

using ::testing::AllOf;
using testing::offers;
using testing::refusal;
using testing::says;

const InputUnit certain_mm{LengthUnit::millimetre, true};

TEST(CheckSize, TakesVertebraeAndRefusesWithTheLikelyUnit) {
  for (const double diagonal : {20.0, 90.0, 250.0}) EXPECT_FALSE(check_size(diagonal, {}));
  EXPECT_FALSE(check_size(0.09, LengthUnit::metre));
  const auto refused = [](double diagonal, const InputUnit& unit) {
    return refusal([&] { check_size(diagonal, unit); });
  };
  EXPECT_THAT(refused(0.09, {}), AllOf(says("0.09 mm"), offers({{RemedyKind::give_unit, "m"}})));
  EXPECT_THAT(refused(9, {}), offers({{RemedyKind::give_unit, "cm"}}));
  EXPECT_THAT(refused(9, LengthUnit::metre), offers({{RemedyKind::give_unit, "cm"}}));
  EXPECT_THAT(refused(90, LengthUnit::metre), offers({{RemedyKind::leave_unit_out}}));
  EXPECT_THAT(refused(1, {}), offers({{RemedyKind::give_unit}})) << "no unit is likely";
}

TEST(CheckSize, OfACertainUnitIsToldAndNotRefused) {
  EXPECT_FALSE(check_size(90, certain_mm));
  const auto note = check_size(0.09, certain_mm);
  ASSERT_TRUE(note);
  EXPECT_THAT(*note, AllOf(says("0.09 mm; a vertebra has 20 to 250 mm"), offers({})));
}

TEST(DoubtAboutLabel, NamesNoUnit) {
  EXPECT_FALSE(doubt_about_label(90));
  ASSERT_TRUE(doubt_about_label(9));
  EXPECT_THAT(*doubt_about_label(9), AllOf(says("a part of one, or more than one"), offers({})));
}

TEST(SizeCheck, NamesTheFirstAndCountsAll) {
  const std::vector<Vec3> good = testing::torus_soup(8, 6).points, small(3, Vec3::Ones());
  SizeCheck strict({});
  strict.add("a.ply", good);
  EXPECT_FALSE(strict.note());
  EXPECT_THAT(refusal([&] { strict.add("b.ply", small); }), says("b.ply: "));
  SizeCheck certain(certain_mm);
  for (const auto& [file, points] : {std::pair{"a.ply", good}, {"b.ply", small}, {"c.ply", small}})
    certain.add(file, points);
  ASSERT_TRUE(certain.note());
  EXPECT_THAT(*certain.note(), says("2 of 3 shapes are not the size of a vertebra: b.ply: "));
}

TEST(SizeCheck, MeasuresInTheGivenUnit) {
  std::vector<Vec3> points = testing::torus_soup(8, 6).points;  // mm, as after a conversion from metres
  SizeCheck metres(LengthUnit::metre);
  metres.add("a.ply", points);
  for (Vec3& p : points) p *= 1000;
  EXPECT_THAT(refusal([&] { metres.add("b.ply", points); }), offers({{RemedyKind::leave_unit_out}}));
}

}  // namespace
}  // namespace foramen
