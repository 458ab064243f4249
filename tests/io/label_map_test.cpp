#include "foramen/io/label_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "io/sha256.hpp"
#include "support/label_maps.hpp"
#include "support/real_data.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using namespace testing;

// Voxels of 0.7 x 0.9 x 2 mm in an oblique direction; left-handed if requested.
LabelMap oblique_map(bool left_handed = false) {
  Mat3 axes = Eigen::AngleAxisd(0.7, Vec3(1, -2, 0.5).normalized()).toRotationMatrix() *
              Vec3(0.7, 0.9, left_handed ? -2.0 : 2.0).asDiagonal();
  int next = 0;
  LabelMap map = labelled_lattice({4, 3, 5}, axes, [&](const Vec3&) { return next++ % 29; });
  map.origin += Vec3(12.5, -80, 300);
  return map;
}

void expect_same(const LabelMap& found, const LabelMap& expected, double tolerance) {
  EXPECT_EQ(found.size, expected.size);
  EXPECT_EQ(found.labels, expected.labels);
  EXPECT_LT((found.axes - expected.axes).cwiseAbs().maxCoeff(), tolerance);
  EXPECT_LT((found.origin - expected.origin).cwiseAbs().maxCoeff(), tolerance * 1e3);
}

constexpr double single_precision = 1e-6, double_precision = 1e-12;

TEST(LabelMapNames, ExtensionsInAnyCaseAndStems) {
  EXPECT_TRUE(is_label_map("a/verse004.nii.gz"));
  EXPECT_TRUE(is_label_map("X.NRRD"));
  EXPECT_FALSE(is_label_map("a.gz"));
  EXPECT_FALSE(is_label_map(".nii.gz"));
  EXPECT_EQ(label_map_stem("a/verse004.seg.nii.gz"), "verse004.seg");
  EXPECT_EQ(label_map_stem("b.MHA"), "b");
}

TEST(ReadLabelMap, NiftiInEveryNumberTypeAndByteOrder) {
  const TemporaryFolder folder;
  const LabelMap map = oblique_map();
  int count = 0;
  const auto check = [&](const std::string& bytes) {
    const std::string name = "map" + std::to_string(count++);
    expect_same(read_label_map(folder.file(name + ".nii", bytes)), map, single_precision);
    expect_same(read_label_map(folder.file(name + ".nii.gz", packed(bytes))), map, single_precision);
  };
  for (const bool big_endian : {false, true}) {
    check(nifti_bytes<std::uint8_t>(map, 2, big_endian));
    check(nifti_bytes<std::int8_t>(map, 256, big_endian));
    check(nifti_bytes<std::int16_t>(map, 4, big_endian));
    check(nifti_bytes<std::uint16_t>(map, 512, big_endian));
    check(nifti_bytes<std::int32_t>(map, 8, big_endian));
    check(nifti_bytes<std::uint32_t>(map, 768, big_endian));
    check(nifti_bytes<std::int64_t>(map, 1024, big_endian));
    check(nifti_bytes<std::uint64_t>(map, 1280, big_endian));
    check(nifti_bytes<float>(map, 16, big_endian));
    check(nifti_bytes<double>(map, 64, big_endian));
  }
}

TEST(ReadLabelMap, LeftHandedAxesStayLeftHanded) {
  const TemporaryFolder folder;
  const LabelMap map = oblique_map(true);
  ASSERT_LT(map.axes.determinant(), 0);
  expect_same(read_label_map(folder.file("a.nii", nifti_bytes(map))), map, single_precision);
  const std::string raw = voxel_bytes<std::uint16_t>(map);
  expect_same(read_label_map(folder.file("a.nrrd", nrrd_header(map) + "encoding: raw\n\n" + raw)), map,
              double_precision);
  expect_same(read_label_map(folder.file("a.mha", meta_header(map) + "ElementDataFile = LOCAL\n" + raw)), map,
              double_precision);
}

// The quaternion of a rotation, as NIfTI stores it, and pixdim[0] for a left-handed lattice.
TEST(ReadLabelMap, NiftiQform) {
  const TemporaryFolder folder;
  for (const bool left_handed : {false, true}) {
    const LabelMap map = oblique_map(left_handed);
    std::string bytes = nifti_bytes(map);
    set_value<std::int16_t>(bytes, 254, 0);
    set_value<std::int16_t>(bytes, 252, 1);
    Mat3 ras = Vec3(-1, -1, 1).asDiagonal() * map.axes;
    for (int d = 0; d < 3; ++d) ras.col(d).normalize();
    if (left_handed) ras.col(2) *= -1;
    ASSERT_NEAR(ras.determinant(), 1, 1e-12);
    Eigen::Quaterniond q(ras);
    if (q.w() < 0) q.coeffs() *= -1;
    set_value<float>(bytes, 76, left_handed ? -1.0F : 1.0F);
    const std::array<double, 6> values{q.x(), q.y(), q.z(), -map.origin.x(), -map.origin.y(), map.origin.z()};
    for (std::size_t i = 0; i < values.size(); ++i)
      set_value<float>(bytes, 256 + 4 * i, static_cast<float>(values[i]));
    expect_same(read_label_map(folder.file("q.nii", bytes)), map, 2 * single_precision);
  }
}

TEST(ReadLabelMap, NiftiScalingUnitsAndDimensionsOfOne) {
  const TemporaryFolder folder;
  const LabelMap map = oblique_map();
  LabelMap half = map;
  for (auto& label : half.labels) label = static_cast<std::uint16_t>(2 * label + 6);
  std::string scaled = nifti_bytes(half);
  set_value<float>(scaled, 112, 0.5F);
  set_value<float>(scaled, 116, -3);
  expect_same(read_label_map(folder.file("scaled.nii", scaled)), map, single_precision);

  std::string five = nifti_bytes(map);
  set_value<std::int16_t>(five, 40, 5);
  expect_same(read_label_map(folder.file("five.nii", five)), map, single_precision);

  LabelMap small = map;
  small.axes /= 1000;
  small.origin /= 1000;
  std::string metres = nifti_bytes(small);
  metres[123] = 1;
  expect_same(read_label_map(folder.file("metres.nii", metres)), map, 10 * single_precision);
}

TEST(ReadLabelMap, NiftiOfTheSecondVersion) {
  const TemporaryFolder folder;
  const LabelMap map = oblique_map();
  for (const bool big_endian : {false, true})
    expect_same(read_label_map(folder.file("a.nii.gz", packed(nifti2_bytes(map, big_endian)))), map,
                double_precision);

  // By the qform, scaled, and in metres.
  const LabelMap left_handed = oblique_map(true);
  LabelMap stored = left_handed;
  for (auto& label : stored.labels) label = static_cast<std::uint16_t>(2 * label + 6);
  std::string bytes = nifti2_bytes(stored);
  set_value<double>(bytes, 176, 0.5);
  set_value<double>(bytes, 184, -3);
  set_value<std::int32_t>(bytes, 500, 1);
  set_value<std::int32_t>(bytes, 344, 1);
  set_value<std::int32_t>(bytes, 348, 0);
  Mat3 ras = Vec3(-1, -1, 1).asDiagonal() * left_handed.axes;
  for (int d = 0; d < 3; ++d) {
    set_value<double>(bytes, 112 + 8 * static_cast<std::size_t>(d), ras.col(d).norm() / 1000);
    ras.col(d).normalize();
  }
  set_value<double>(bytes, 104, -1);
  ras.col(2) *= -1;
  Eigen::Quaterniond q(ras);
  if (q.w() < 0) q.coeffs() *= -1;
  const Vec3 origin = Vec3(-1, -1, 1).cwiseProduct(left_handed.origin) / 1000;
  const std::array<double, 6> values{q.x(), q.y(), q.z(), origin.x(), origin.y(), origin.z()};
  for (std::size_t i = 0; i < values.size(); ++i) set_value<double>(bytes, 352 + 8 * i, values[i]);
  expect_same(read_label_map(folder.file("q.nii", bytes)), left_handed, 100 * double_precision);
}

TEST(ReadLabelMap, NrrdInItsSpacesAndEncodings) {
  const TemporaryFolder folder;
  const LabelMap map = oblique_map();
  const std::string raw = voxel_bytes<std::uint16_t>(map);
  const std::pair<std::string, Vec3> spaces[] = {{"left-posterior-superior", {1, 1, 1}},
                                                 {"LPS", {1, 1, 1}},
                                                 {"right-anterior-superior", {-1, -1, 1}},
                                                 {"LAS", {1, -1, 1}}};
  for (const auto& [space, signs] : spaces) {
    SCOPED_TRACE(space);
    const std::string header = nrrd_header(map, space, signs);
    expect_same(read_label_map(folder.file("a.nrrd", header + "encoding: gzip\n\n" + packed(raw))), map,
                double_precision);
  }
  folder.file("a.raw.gz", packed(raw));
  const auto detached = folder.file("a.nhdr", nrrd_header(map) + "encoding: gz\ndata file: a.raw.gz\n");
  const LabelMap found = read_label_map(detached);
  expect_same(found, map, double_precision);
  EXPECT_EQ(found.sha256, sha256(bytes_of(detached) + packed(raw))) << "header, then data";
}

TEST(ReadLabelMap, MetaImageInItsEncodings) {
  const TemporaryFolder folder;
  const LabelMap map = oblique_map();
  const std::string raw = voxel_bytes<std::uint16_t>(map);
  const auto compressed = folder.file(
      "a.mha", meta_header(map) + "CompressedData = True\nElementDataFile = LOCAL\n" + packed(raw, false));
  expect_same(read_label_map(compressed), map, double_precision);
  EXPECT_EQ(read_label_map(compressed).sha256, sha256_of_file(compressed));
  folder.file("a.raw", raw);
  expect_same(read_label_map(folder.file("a.mhd", meta_header(map) + "ElementDataFile = a.raw\n")), map,
              double_precision);
  std::string big = meta_header(map);
  big.replace(big.find("MSB = False"), 11, "MSB = True");
  expect_same(read_label_map(folder.file(
                  "b.mha", big + "ElementDataFile = LOCAL\n" + voxel_bytes<std::uint16_t>(map, true))),
              map, double_precision);
}

// Files that ITK 5.2.1 wrote of one image of 3 x 4 x 5 voxels, 0.75 x 1.25 x 2.5 mm, in a left-handed oblique
// direction, voxel (i, j, k) being 100 k + 10 j + i. ITK says where voxel (2, 3, 4) is.
TEST(ReadLabelMap, FilesWrittenByItkStandWhereItkSays) {
  const TemporaryFolder folder;
  const std::filesystem::path itk = std::filesystem::path(FORAMEN_TESTS_DIR) / "io" / "written_by_itk";
  std::string by_quaternion = bytes_of(itk / "oblique.nii");
  set_value<std::int16_t>(by_quaternion, 254, 0);
  for (const auto& file : {itk / "oblique.nii", folder.file("qform.nii", by_quaternion), itk / "oblique.nrrd",
                           itk / "oblique.mha", itk / "oblique.mhd"}) {
    SCOPED_TRACE(file);
    const LabelMap map = read_label_map(file);
    ASSERT_EQ(map.size, (std::array{3, 4, 5}));
    for (int k = 0; k < 5; ++k)
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 3; ++i) EXPECT_EQ(map.at(i, j, k), 100 * k + 10 * j + i);
    EXPECT_LT((map.origin - Vec3(10.5, -20.25, 300)).norm(), 1e-5);
    EXPECT_LT(
        (map.origin + map.axes * Vec3(2, 3, 4) - Vec3(13.6740381057, -28.5911450702, 306.055021141)).norm(),
        1e-5);
    EXPECT_LT(map.axes.determinant(), 0);
  }
}

TEST(ReadLabelMapRealData, TheVerseLabelMap) {
  FORAMEN_NEEDS_REAL_DATA();
  const LabelMap map = read_label_map(data_dir() / "labels" / "verse004.nii.gz");
  EXPECT_EQ(map.size, (std::array{161, 338, 61}));
  EXPECT_EQ(*std::max_element(map.labels.begin(), map.labels.end()), 24);
  const Vec3 spacing = map.axes.colwise().norm().transpose();
  EXPECT_LT((spacing - Vec3(1, 1, 2)).cwiseAbs().maxCoeff(), 1e-3);
}

}  // namespace
}  // namespace foramen
