#include "workflow/repair_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "support/meshes.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

// A torus without one triangle, and with a point that no triangle uses.
TriangleSoup torus_with_a_hole() {
  TriangleSoup soup = testing::torus_soup(24, 12);
  soup.triangles.pop_back();
  soup.points.emplace_back(1, 2, 3);
  return soup;
}

TEST(RepairFile, WritesInTheUnitAndTheAxesOfTheInput) {
  const testing::TemporaryFolder folder;
  TriangleSoup soup = torus_with_a_hole();
  for (Vec3& p : soup.points) p /= 10;
  write_ply(folder.file("raw.ply"), soup, AnatomicalSpace::ras);
  const RepairSummary summary = repair_file(
      {.input = folder.file("raw.ply"), .output = folder.file("out.vtp"), .unit = LengthUnit::centimetre},
      RunContext(1));
  EXPECT_FALSE(summary.refusal);
  EXPECT_THAT(summary.notes, IsEmpty());
  EXPECT_THAT(
      summary.lines,
      ElementsAre(StartsWith(folder.file("raw.ply").string() + ": "), StartsWith("the canal: "),
                  "wrote " + folder.file("out.vtp").string() + ": 288 vertices, 576 triangles, genus 1"));
  const MeshFile written = read_mesh(folder.file("out.vtp"));
  EXPECT_EQ(written.space, AnatomicalSpace::ras);
  const auto record = nlohmann::json::parse(summary.json);
  EXPECT_EQ(record.at("triangles"), 576);
  ASSERT_EQ(record.at("origin").size(), written.soup.points.size());
  for (std::size_t v = 0; v < written.soup.points.size(); ++v)
    EXPECT_LT((written.soup.points[v] - soup.points[record.at("origin").at(v)]).norm(), 1e-6);
}

TEST(RepairFile, WhatIsRefusedKeepsTheNotesAndLeavesNoFile) {
  const testing::TemporaryFolder folder;
  // A tetrahedron in an ASCII file that has one more line than its header says.
  const fs::path sphere = folder.file("sphere.off",
                                      "OFF\n4 4 0\n0 0 0\n40 0 0\n0 40 0\n0 0 40\n3 0 2 1\n3 0 1 3\n3 1 2 3\n"
                                      "3 2 0 3\n3 0 0 0\n");
  const RepairSummary summary =
      repair_file({.input = sphere, .output = folder.file("out.ply")}, RunContext(1));
  ASSERT_TRUE(summary.refusal);
  EXPECT_THAT(*summary.refusal, testing::says("sphere.off: genus 0"));
  EXPECT_THAT(summary.notes, ElementsAre(testing::says("sphere.off: ")));
  EXPECT_FALSE(fs::exists(folder.file("out.ply")));
}

TEST(RepairFile, ASizeThatIsCertainIsNoted) {
  const testing::TemporaryFolder folder;
  TriangleSoup soup = testing::torus_soup(24, 12);
  for (Vec3& p : soup.points) p *= 10;
  write_ply(folder.file("giant.ply"), soup);
  const fs::path out = folder.file("out.ply");
  EXPECT_TRUE(repair_file({.input = folder.file("giant.ply"), .output = out}, RunContext(1)).refusal);
  const RepairSummary certain =
      repair_file({.input = folder.file("giant.ply"), .output = out, .unit = {LengthUnit::millimetre, true}},
                  RunContext(1));
  EXPECT_FALSE(certain.refusal);
  EXPECT_THAT(certain.notes, ElementsAre(testing::says("giant.ply: ")));
}

TEST(RepairFile, AnotherKindOfFileIsRefusedBeforeTheInputIsRead) {
  const Message refused =
      testing::refusal([] { repair_file({.input = "/no/such/file", .output = "out.obj"}, RunContext(1)); });
  EXPECT_THAT(refused, testing::says("out.obj: a repaired surface is written as .ply or .vtp"));
  EXPECT_THAT(refused, testing::offers({{RemedyKind::another_output}}));
}

}  // namespace
}  // namespace foramen
