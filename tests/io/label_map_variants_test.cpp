// Label maps as programs of all kinds write them: each must be read as the plain file is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <Eigen/Geometry>

#include "foramen/core/error.hpp"
#include "foramen/io/label_map.hpp"
#include "io/sha256.hpp"
#include "support/label_maps.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using namespace testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

LabelMap plain_map() {
  int next = 0;
  return labelled_lattice({4, 3, 6}, Vec3(1, 1.5, 2).asDiagonal(), [&](const Vec3&) { return next++ % 25; });
}

void expect_plain(const LabelMap& found) {
  const LabelMap plain = plain_map();
  EXPECT_EQ(found.size, plain.size);
  EXPECT_EQ(found.labels, plain.labels);
  EXPECT_LT((found.axes - plain.axes).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT((found.origin - plain.origin).cwiseAbs().maxCoeff(), 1e-5);
}

std::string meta_text() { return meta_header(plain_map()); }
std::string raw_voxels() { return voxel_bytes<std::uint16_t>(plain_map()); }

// The map as integers of the whole range of T that a scaling maps back, as nibabel writes floats.
template <class T>
std::string scaled_nifti(int type) {
  const double low = std::numeric_limits<T>::min(), high = std::numeric_limits<T>::max();
  const float slope = static_cast<float>(24 / (high - low)), intercept = static_cast<float>(-low * slope);
  LabelMap map = plain_map();
  std::string bytes = nifti_bytes<T>(map, type);
  for (std::size_t v = 0; v < map.labels.size(); ++v)
    set_value<T>(bytes, 352 + v * sizeof(T),
                 static_cast<T>(std::lround((map.labels[v] - intercept) / slope)));
  set_value<float>(bytes, 112, slope);
  set_value<float>(bytes, 116, intercept);
  return bytes;
}

TEST(LabelMapVariants, ScaledLabelsAreRounded) {
  const TemporaryFolder folder;
  expect_plain(read_label_map(folder.file("a.nii", scaled_nifti<std::uint16_t>(512))));
  expect_plain(read_label_map(folder.file("a.nii", scaled_nifti<std::int16_t>(4))));
  const LabelMap bytes = read_label_map(folder.file("a.nii", scaled_nifti<std::uint8_t>(2)));
  expect_plain(bytes);
  ASSERT_EQ(bytes.notes.size(), 1u);
  EXPECT_THAT(bytes.notes[0].text, HasSubstr("were rounded, by 0.0"));
}

TEST(LabelMapVariants, FloatsNearWholeNumbersAreRoundedUpToALimit) {
  const TemporaryFolder folder;
  std::string floats = nifti_bytes<float>(plain_map(), 16);
  const auto with = [&](float value) {
    set_value<float>(floats, 352 + 4 * 20, value);
    return read_label_map(folder.file("a.nii", floats));
  };
  expect_plain(with(19.9999F));
  expect_plain(with(20.049F));
  EXPECT_TRUE(with(20).notes.empty());
  EXPECT_THROW(with(20.06F), IoError);
  EXPECT_THROW(with(19.94F), IoError);
  set_value<float>(floats, 352, -0.01F);  // a background of nearly zero
  expect_plain(with(20.01F));
}

TEST(LabelMapVariants, CompressionIsSeenByTheContent) {
  const TemporaryFolder folder;
  const std::string nifti = nifti_bytes(plain_map()), nrrd = nrrd_header(plain_map()), raw = raw_voxels();
  const std::string meta = meta_text();
  expect_plain(read_label_map(folder.file("a.nii.gz", nifti)));
  expect_plain(read_label_map(folder.file("a.nii", packed(nifti))));
  expect_plain(read_label_map(folder.file("a.nrrd", nrrd + "encoding: gzip\n\n" + raw)));
  expect_plain(read_label_map(folder.file("a.nrrd", nrrd + "encoding: raw\n\n" + packed(raw))));
  expect_plain(
      read_label_map(folder.file("a.mha", meta + "CompressedData = True\nElementDataFile = LOCAL\n" + raw)));
  expect_plain(read_label_map(folder.file("a.mha", meta + "ElementDataFile = LOCAL\n" + packed(raw))));
}

TEST(LabelMapVariants, ByteOrderMarksBeforeTextHeaders) {
  const TemporaryFolder folder;
  const std::string mark = "\xef\xbb\xbf", raw = raw_voxels();
  expect_plain(
      read_label_map(folder.file("a.nrrd", mark + nrrd_header(plain_map()) + "encoding: raw\n\n" + raw)));
  expect_plain(read_label_map(folder.file("a.mha", mark + meta_text() + "ElementDataFile = LOCAL\n" + raw)));
}

// A quaternion of no rotation stands for the axes of RAS, in which the map's x and y are negative.
TEST(LabelMapVariants, AnUnusableSformGivesWayToTheQform) {
  const TemporaryFolder folder;
  std::string bytes = nifti_bytes(plain_map());
  set_value<std::int16_t>(bytes, 252, 1);
  set_value<float>(bytes, 264, 1);  // half a turn about z
  for (int row = 0; row < 3; ++row)
    set_value<float>(bytes, 268 + 4 * static_cast<std::size_t>(row),
                     static_cast<float>((row < 2 ? -1 : 1) * plain_map().origin[row]));
  std::string zero = bytes, sheared = bytes, not_a_number = bytes;
  for (std::size_t at = 280; at < 328; at += 4) set_value<float>(zero, at, 0);
  set_value<float>(sheared, 284, 0.4F);
  set_value<float>(not_a_number, 280, std::numeric_limits<float>::quiet_NaN());
  for (const std::string& bad : {zero, sheared, not_a_number}) {
    const LabelMap map = read_label_map(folder.file("a.nii", bad));
    expect_plain(map);
    ASSERT_EQ(map.notes.size(), 1u);
    EXPECT_THAT(map.notes[0].text, HasSubstr("its sform cannot be used"));
  }
  set_value<float>(bytes, 268, 500);  // a usable sform is taken, whatever the qform says
  expect_plain(read_label_map(folder.file("a.nii", bytes)));
}

TEST(LabelMapVariants, AxesOfLengthOne) {
  const TemporaryFolder folder;
  const std::string raw = raw_voxels();
  std::string nifti = nifti_bytes(plain_map());
  set_value<std::int16_t>(nifti, 40, 4);
  for (const auto length : {std::int16_t{0}, std::int16_t{1}}) {
    set_value<std::int16_t>(nifti, 48, length);
    expect_plain(read_label_map(folder.file("a.nii", nifti)));
  }
  const auto changed = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  std::string nrrd = changed(nrrd_header(plain_map()), "dimension: 3", "dimension: 4");
  nrrd = changed(changed(nrrd, "sizes: ", "sizes: 1 "), "directions: ", "directions: none ");
  expect_plain(read_label_map(folder.file("a.nrrd", nrrd + "encoding: raw\n\n" + raw)));
  const Vec3 origin = plain_map().origin;
  expect_plain(read_label_map(folder.file(
      "a.mha", "NDims = 4\nBinaryData = True\nTransformMatrix = 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\nOffset = " +
                   numbers(origin, " ") + " 0\nElementSpacing = 1 1.5 2 1\nDimSize = 4 3 6 1\n" +
                   "ElementType = MET_USHORT\nElementDataFile = LOCAL\n" + raw)));
}

TEST(LabelMapVariants, DataAtTheEndOfAFileOrBehindAHeader) {
  const TemporaryFolder folder;
  const std::string raw = raw_voxels(), foreign(123, 'h');
  folder.file("a.raw", foreign + raw);
  for (const char* size : {"HeaderSize = -1\n", "HeaderSize = 123\n"})
    expect_plain(read_label_map(folder.file("a.mhd", meta_text() + size + "ElementDataFile = a.raw\n")));
  expect_plain(
      read_label_map(folder.file("b.mha", meta_text() + "HeaderSize = -1\nElementDataFile = LOCAL\n" + raw)));
  for (const char* skip : {"byte skip: -1\n", "byte skip: 123\n"})
    expect_plain(read_label_map(
        folder.file("a.nhdr", nrrd_header(plain_map()) + "encoding: raw\n" + skip + "data file: a.raw\n")));
}

TEST(LabelMapVariants, MetaImageOfFewFields) {
  const TemporaryFolder folder;
  const LabelMap map = read_label_map(
      folder.file("a.mha",
                  "NDims = 3\nDimSize = 2 2 1\nElementType = MET_UCHAR\nElementSpacing = 1 2 3\n"
                  "ElementDataFile = LOCAL\n\1\2\3\4"));
  EXPECT_EQ(map.origin, Vec3(0, 0, 0));
  EXPECT_EQ(map.axes, Mat3(Vec3(1, 2, 3).asDiagonal()));
  EXPECT_EQ(map.labels, (std::vector<std::uint16_t>{1, 2, 3, 4}));
  EXPECT_TRUE(map.notes.empty());
}

TEST(LabelMapVariants, MetaImageWithoutSpacingIsOfOneMillimetreAndSaysSo) {
  const TemporaryFolder folder;
  const LabelMap map = read_label_map(folder.file(
      "a.mha", "NDims = 3\nDimSize = 2 2 1\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n\1\2\3\4"));
  EXPECT_EQ(map.axes, Mat3(Mat3::Identity()));
  ASSERT_EQ(map.notes.size(), 1u);
  EXPECT_NE(map.notes[0].text.find("voxels of 1 mm were assumed"), std::string::npos);
}

TEST(LabelMapVariants, SlicesInSeveralFiles) {
  const TemporaryFolder folder;
  const std::string raw = raw_voxels();
  std::filesystem::create_directory(folder.path() / "s");
  std::string list, bytes;
  for (int k = 0; k < 6; ++k) {
    const std::string name = "s/slice_0" + std::to_string(k + 1) + ".raw";
    const std::string slice = raw.substr(static_cast<std::size_t>(k) * 24, 24);
    folder.file(name, slice);
    list += name + "\n";
    bytes += slice;
  }
  const auto header = folder.file("a.mhd", meta_text() + "ElementDataFile = LIST\n" + list);
  expect_plain(read_label_map(header));
  EXPECT_EQ(read_label_map(header).sha256, sha256(bytes_of(header) + bytes));
  expect_plain(
      read_label_map(folder.file("b.mhd", meta_text() + "ElementDataFile = s/slice_%02d.raw 1 6 1\n")));
  expect_plain(read_label_map(folder.file(
      "c.nhdr", nrrd_header(plain_map()) + "encoding: raw\ndata file: s/slice_%02d.raw 1 6 1\n")));
  expect_plain(read_label_map(
      folder.file("d.nhdr", nrrd_header(plain_map()) + "encoding: raw\ndata file: LIST\n" + list)));
  // Five files for six slices.
  EXPECT_THROW(
      read_label_map(folder.file("e.mhd", meta_text() + "ElementDataFile = s/slice_%02d.raw 1 5 1\n")),
      IoError);
  // A link that leads out of the folder is no file of it.
  std::filesystem::create_symlink("/etc", folder.path() / "out");
  EXPECT_THROW(read_label_map(folder.file("f.mhd", meta_text() + "ElementDataFile = LIST\nout/passwd\n")),
               IoError);
}

}  // namespace
}  // namespace foramen
