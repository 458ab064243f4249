#include "inputs/read_cohort.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "foramen/core/geometry.hpp"
#include "support/handles.hpp"
#include "support/label_maps.hpp"
#include "support/meshes.hpp"
#include "support/messages.hpp"
#include "support/real_data.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using testing::bytes_of;
using testing::offers;
using testing::packed;
using testing::refusal;
using testing::says;
using testing::TemporaryFolder;
using testing::torus_soup;

TEST(FindMeshes, FilesAndFoldersInOrderOfStem) {
  const TemporaryFolder folder;
  for (const char* name : {"b.ply", "a.PLY", "notes.txt"}) folder.file(name, "");
  const auto found = find_meshes({folder.path(), folder.path() / "b.ply"}).files;
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].path.filename(), "a.PLY");
  EXPECT_EQ(found[1].path.filename(), "b.ply");
}

TEST(FindMeshes, RefusesWhatIsMissingEmptyOrAmbiguous) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal([&] { find_meshes({folder.path() / "none.ply"}); }), says("no such file"));
  EXPECT_THAT(refusal([&] { find_meshes({folder.path()}); }), says("holds no mesh file"));
  folder.file("a.ply", "");
  folder.file("a.stl", "");
  EXPECT_THAT(refusal([&] { find_meshes({folder.path()}); }), says("same name"));
}

TEST(FindMeshes, AFolderOfDicomIsNamed) {
  const TemporaryFolder folder;
  std::string slice(128, '\0');
  slice += "DICM";
  folder.file("IM0001", slice);
  EXPECT_THAT(refusal([&] { find_meshes({folder.path()}); }), says("is a DICOM file"));
}

TEST(ReadCohort, PackedMeshesAndNotesOnHowTheyWereRead) {
  const TemporaryFolder folder;
  write_ply(folder.file("plain.ply"), torus_soup(24, 12));
  TriangleSoup other = torus_soup(24, 12);
  for (Vec3& p : other.points) p *= 1.1;
  write_ply(folder.file("other.ply"), other);
  folder.file("tail.ply.gz", packed(bytes_of(folder.file("other.ply")) + "tail"));
  std::filesystem::remove(folder.file("other.ply"));
  const Cohort cohort =
      read_cohort(find_meshes({folder.path()}).files, LengthUnit::millimetre, RunContext(1));
  ASSERT_EQ(cohort.shapes.size(), 2u);
  EXPECT_EQ(cohort.shapes[1].stem, "tail");
  ASSERT_EQ(cohort.notes.size(), 1u);
  EXPECT_EQ(cohort.notes[0].text, "tail.ply.gz: 4 bytes after the surface passed over");
}

TEST(ReadShape, InwardWindingIsReversedAndSaid) {
  const TemporaryFolder folder;
  TriangleSoup soup = torus_soup(24, 12);
  for (auto& t : soup.triangles) std::swap(t[0], t[1]);
  write_ply(folder.file("in.ply"), soup, AnatomicalSpace::ras);
  const InputShape shape = read_shape(folder.file("in.ply"), LengthUnit::millimetre);
  EXPECT_TRUE(shape.was_inward);
  EXPECT_GT(signed_volume(shape.mesh), 0);
  EXPECT_EQ(shape.space, AnatomicalSpace::ras);
  EXPECT_EQ(shape.sha256.size(), 64u);
}

TEST(ReadShape, UnitsAreConvertedAndImplausibleOnesRefused) {
  const TemporaryFolder folder;
  TriangleSoup soup = torus_soup(24, 12);
  const double area_mm = total_area(build_mesh(soup));
  for (Vec3& p : soup.points) p /= 10;
  write_ply(folder.file("cm.ply"), soup);
  EXPECT_NEAR(total_area(read_shape(folder.file("cm.ply"), LengthUnit::centimetre).mesh) / area_mm, 1, 1e-5);
  EXPECT_THAT(refusal([&] { read_shape(folder.file("cm.ply"), LengthUnit::millimetre); }),
              AllOf(says("probably in cm"), offers({{RemedyKind::give_unit, "cm"}})));
}

TEST(ReadCohort, OneBadFileIsLeftOutWithItsReason) {
  const TemporaryFolder folder;
  write_ply(folder.file("good.ply"), torus_soup(24, 12));
  TriangleSoup open = torus_soup(24, 12);
  open.triangles.pop_back();
  write_ply(folder.file("open.ply"), open);
  folder.file("torn.ply", "ply\nformat ascii 1.0\n");
  const Cohort cohort =
      read_cohort(find_meshes({folder.path()}).files, LengthUnit::millimetre, RunContext(2));
  ASSERT_EQ(cohort.shapes.size(), 1u);
  ASSERT_EQ(cohort.left_out.size(), 2u);
  EXPECT_EQ(cohort.left_out[0].file_name, "open.ply");
  EXPECT_EQ(cohort.left_out[1].file_name, "torn.ply");
  for (const LeftOut& left_out : cohort.left_out)
    EXPECT_THAT(left_out.reason, ::testing::Not(says(left_out.file_name))) << "a list names its files itself";
  EXPECT_THAT(cohort.left_out[0].reason, AllOf(says("it is open: "), offers({{RemedyKind::repair}})));
  EXPECT_THAT(cohort.left_out[1].reason, AllOf(says("its header"), offers({})));
}

// A torus with a thin bridge and a hole, both of which can be repaired.
TriangleSoup defective() {
  testing::TorusWithHandles torus(120, 60);
  torus.bridge(10, 20, 14);
  torus.shake(0.01, 1);
  torus.soup.triangles.erase(torus.soup.triangles.begin() + 9000);
  return torus.soup;
}

TEST(ReadCohort, WhatTheAuditRefusesIsRepairedOnRequest) {
  const TemporaryFolder folder;
  write_ply(folder.file("good.ply"), torus_soup(24, 12));
  write_ply(folder.file("mendable.ply"), defective());
  TriangleSoup cut_off = torus_soup(24, 12);
  cut_off.triangles.resize(cut_off.triangles.size() / 2);
  write_ply(folder.file("cut_off.ply"), cut_off);
  folder.file("torn.ply", "ply\nformat ascii 1.0\n");
  const auto files = find_meshes({folder.path()}).files;
  EXPECT_EQ(read_cohort(files, LengthUnit::millimetre, RunContext(2)).shapes.size(), 1u);
  const Cohort cohort = read_cohort(files, LengthUnit::millimetre, RunContext(2), {}, RepairOptions());
  ASSERT_EQ(cohort.shapes.size(), 2u);
  EXPECT_FALSE(cohort.shapes[0].repair);
  ASSERT_TRUE(cohort.shapes[1].repair);
  const RepairReport& report = *cohort.shapes[1].repair;
  EXPECT_EQ(report.removed_handles.size(), 1u);
  EXPECT_THAT(summary(report), ::testing::HasSubstr("holes filled: 1 at ("));
  EXPECT_EQ(report.changes.size(), 2u);
  EXPECT_EQ(report.removed_handles[0].kind, LoopKind::handle);
  EXPECT_EQ(report.canal.kind, LoopKind::tunnel);
  // The result has the coordinates of the file. Only the patches are new.
  const TriangleSoup raw = read_mesh(folder.file("mendable.ply")).soup;
  std::size_t kept = 0;
  for (const Vec3& p : cohort.shapes[1].mesh.positions())
    kept += std::find(raw.points.begin(), raw.points.end(), p) != raw.points.end() ? 1 : 0;
  EXPECT_GT(kept, raw.points.size() - 30);
  ASSERT_EQ(cohort.left_out.size(), 2u);
  EXPECT_THAT(cohort.left_out[0].reason, says("it is open: a hole of"));
  EXPECT_THAT(cohort.left_out[1].reason, says("its header"));
}

TEST(RepairSurface, TakesUnitsAndRefusesWrongOnes) {
  TriangleSoup soup = defective();
  for (Vec3& p : soup.points) p /= 1000;
  const RepairedMesh repaired = repair_surface(soup, LengthUnit::metre, {}, RunContext(1));
  EXPECT_NEAR(repaired.report.canal.length_mm, 75, 2);
  EXPECT_THAT(refusal([&] { repair_surface(soup, LengthUnit::millimetre, {}, RunContext(1)); }),
              AllOf(says("probably in m"), offers({{RemedyKind::give_unit, "m"}})));
  // A piece far away does not make it another unit.
  soup = defective();
  soup.points.insert(soup.points.end(), {Vec3(600, 0, 0), Vec3(601, 0, 0), Vec3(600, 1, 0)});
  const int n = static_cast<int>(soup.points.size());
  soup.triangles.push_back({n - 3, n - 2, n - 1});
  EXPECT_EQ(repair_surface(soup, LengthUnit::millimetre, {}, RunContext(1)).report.changes.size(), 3u);
}

TEST(ReadCohort, RealDataDefectiveVertebraeAreUsedWhenRepaired) {
  FORAMEN_NEEDS_REAL_DATA();
  const auto files = find_meshes({testing::data_dir() / "defective"}).files;
  EXPECT_EQ(read_cohort(files, LengthUnit::millimetre, RunContext(2)).left_out.size(), 5u);
  const Cohort cohort = read_cohort(files, LengthUnit::millimetre, RunContext(2), {}, RepairOptions());
  EXPECT_TRUE(cohort.left_out.empty());
  ASSERT_EQ(cohort.shapes.size(), 5u);
  for (const InputShape& shape : cohort.shapes) EXPECT_TRUE(shape.repair) << shape.stem;
}

}  // namespace
}  // namespace foramen
