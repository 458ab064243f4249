#include "workflow/inspect_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "foramen/core/error.hpp"
#include "support/double_torus.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

TEST(InspectFile, AFileThatCannotBeReadIsAnError) {
  const testing::TemporaryFolder folder;
  const InspectedFile inspected = inspect_file({.file = folder.file("none.ply", "no mesh")}, RunContext(1));
  EXPECT_FALSE(inspected.usable());
  ASSERT_TRUE(inspected.error);
  EXPECT_THAT(*inspected.error, testing::says("none.ply"));
  const auto json = inspection_json(inspected);
  EXPECT_EQ(json.at("usable"), false);
  EXPECT_EQ(json.at("finding"), inspected.error->text);
}

TEST(InspectFile, LengthsAreInMillimetresAndTheSizeSpeaksOfTheUnit) {
  const testing::TemporaryFolder folder;
  TriangleSoup soup = testing::torus_soup(24, 12);
  for (Vec3& p : soup.points) p /= 10;
  write_ply(folder.file("cm.ply"), soup, AnatomicalSpace::ras);
  const auto with = [&](const InputUnit& unit) {
    return inspect_file({.file = folder.file("cm.ply"), .unit = unit}, RunContext(1));
  };
  const InspectedFile right = with(LengthUnit::centimetre), wrong = with(LengthUnit::millimetre);
  EXPECT_TRUE(right.usable());
  EXPECT_EQ(right.space, AnatomicalSpace::ras);
  EXPECT_NEAR(right.report.area, 100 * wrong.report.area, 1e-6 * right.report.area);
  EXPECT_EQ(right.size_unit, "mm");
  EXPECT_EQ(wrong.size_unit, "not mm; probably cm");
  EXPECT_EQ(with({LengthUnit::millimetre, true}).size_unit, "mm; the size of no vertebra");
  EXPECT_EQ(with(LengthUnit::metre).size_unit, "mm; the size of no vertebra: the file is not in m");
  EXPECT_EQ(inspection_json(right).at("space"), "RAS");
}

TEST(InspectFile, FindsTheHandlesOfASurfaceThatHasMoreThanTheCanal) {
  const testing::TemporaryFolder folder;
  write_ply(folder.file("two.ply"), testing::bumpy_genus2_soup(24, 12, 1));
  write_ply(folder.file("one.ply"), testing::torus_soup(24, 12));
  const InspectedFile two = inspect_file({.file = folder.file("two.ply")}, RunContext(1));
  EXPECT_FALSE(two.usable());
  ASSERT_TRUE(two.handles);
  EXPECT_EQ(two.handles->extra.size(), 1u);
  EXPECT_EQ(inspection_json(two).at("handles").at("extra").at(0).at("noise"), false);
  EXPECT_FALSE(inspect_file({.file = folder.file("two.ply"), .find_handles = false}, RunContext(1)).handles);
  EXPECT_FALSE(inspect_file({.file = folder.file("one.ply")}, RunContext(1)).handles);
}

TEST(InspectFile, AStopIsNoFindingOfTheFile) {
  const testing::TemporaryFolder folder;
  write_ply(folder.file("two.ply"), testing::bumpy_genus2_soup(24, 12, 1));
  const RunContext ctx(1);
  ctx.request_stop();
  EXPECT_THROW(inspect_file({.file = folder.file("two.ply")}, ctx), Cancelled);
}

}  // namespace
}  // namespace foramen
