// An error in a label map is found before memory is allocated for the map, and is named in the message.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "foramen/core/error.hpp"
#include "foramen/io/label_map.hpp"
#include "support/label_maps.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using namespace testing;
using ::testing::HasSubstr;

LabelMap small_map() {
  int next = 0;
  return labelled_lattice({6, 5, 4}, Vec3(1, 1, 2).asDiagonal(), [&](const Vec3&) { return next++ % 7; });
}

struct Case {
  std::string what, name, bytes, message;
};

std::string replaced(std::string text, const std::string& part, const std::string& with) {
  const auto at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.replace(at, part.size(), with);
}

template <class T>
std::string nifti_with(std::size_t offset, T value) {
  std::string bytes = nifti_bytes(small_map());
  set_value<T>(bytes, offset, value);
  return bytes;
}

// With the number of dimensions, and the size along the last of them.
std::string nifti2_with_size(std::int64_t dimensions, std::int64_t size) {
  std::string bytes = nifti2_bytes(small_map());
  set_value<std::int64_t>(bytes, 16, dimensions);
  set_value<std::int64_t>(bytes, 16 + 8 * static_cast<std::size_t>(dimensions), size);
  return bytes;
}

std::vector<Case> nifti_cases() {
  const LabelMap map = small_map();
  const std::string good = nifti_bytes(map);
  std::string wide = good, huge = good, colours = good, no_orientation = good, sheared = good, other = good;
  for (const std::size_t d : {0, 1, 2}) {
    set_value<std::int16_t>(wide, 42 + 2 * d, 1260);
    set_value<std::int16_t>(huge, 42 + 2 * d, 32767);
  }
  set_value<std::int16_t>(wide, 70, 64);  // of 8 bytes
  set_value<std::int16_t>(no_orientation, 254, 0);
  set_value<float>(sheared, 284, 0.2F);
  std::string four = good;
  set_value<std::int16_t>(four, 40, 4);
  set_value<std::int16_t>(four, 48, 3);
  std::string halves = nifti_bytes<float>(map, 16), not_a_number = halves,
              negative = nifti_bytes<std::int16_t>(map, 4);
  set_value<float>(halves, 352 + 40, 2.5F);
  set_value<float>(not_a_number, 352 + 40, std::numeric_limits<float>::quiet_NaN());
  set_value<std::int16_t>(negative, 352 + 40, -1000);
  LabelMap binary = map;
  for (auto& label : binary.labels) label = label > 3;
  std::string probabilities = nifti_bytes<float>(binary, 16), coarse = nifti_bytes<std::int16_t>(map, 4);
  set_value<float>(probabilities, 352 + 40, 0.37F);
  set_value<float>(coarse, 112, 0.4F);
  std::string large = nifti_bytes<std::int32_t>(map, 8);
  set_value<std::int32_t>(large, 352 + 40, 70000);
  std::string flipped_bit = packed(good);
  flipped_bit[flipped_bit.size() - 6] ^= 1;  // in the checksum
  return {
      {"empty", "a.nii", "", "is empty"},
      {"no header", "a.nii", std::string(400, 'x'), "does not begin as a NIfTI header"},
      {"short header", "a.nii", good.substr(0, 100), "has only 100 bytes"},
      {"short packed header", "a.nii.gz", packed(good.substr(0, 100)), "has only 100 bytes"},
      {"16 GB promised", "a.nii", wide, "which need 16003008352 bytes"},
      {"16 GB promised, packed", "a.nii.gz", packed(wide), "compressed ones are there"},
      {"more than can be numbered", "a.nii", huge, "more than foramen can hold"},
      {"negative size", "a.nii", nifti_with<std::int16_t>(44, -5), "6 x -5 x 4"},
      {"two dimensions", "a.nii", nifti_with<std::int16_t>(40, 2), "image of 2 dimensions"},
      {"a series", "a.nii", four, "image of 4 dimensions"},
      {"dimensions out of range", "a.nii", nifti_with<std::int16_t>(40, 300), "image of 300 dimensions"},
      {"RGB", "a.nii", nifti_with<std::int16_t>(70, 128), "type 128"},
      {"complex", "a.nii", nifti_with<std::int16_t>(70, 32), "type 32"},
      {"pair of files", "a.nii", replaced(good, "n+1", "ni1"), "no NIfTI mark"},
      {"mark of NIfTI-1 in a header of NIfTI-2", "a.nii", nifti_with<std::int32_t>(0, 540), "no NIfTI mark"},
      {"header of NIfTI-2 cut off", "a.nii", nifti2_bytes(map).substr(0, 500), "500 bytes"},
      {"four dimensions in NIfTI-2", "a.nii", nifti2_with_size(4, 2), "image of 4 dimensions"},
      {"endless in NIfTI-2", "a.nii", nifti2_with_size(3, std::int64_t{1} << 62), "voxels"},
      {"voxels before the header's end", "a.nii", nifti_with<float>(108, 4), "begin at byte 4"},
      {"voxels beyond the end", "a.nii", nifti_with<float>(108, 1e6F), "are there"},
      {"voxels nowhere", "a.nii", nifti_with<float>(108, std::numeric_limits<float>::quiet_NaN()),
       "begin at byte"},
      {"no orientation", "a.nii", no_orientation, "left and right cannot be told"},
      {"sheared", "a.nii", sheared, "not at right angles"},
      {"no spacing", "a.nii", nifti_with<float>(280, 0), "voxels measure 0"},
      {"infinite spacing", "a.nii", nifti_with<float>(280, std::numeric_limits<float>::infinity()),
       "voxels measure"},
      {"far origin", "a.nii", nifti_with<float>(292, 1e9F), "its origin is at"},
      {"cut off", "a.nii", good.substr(0, good.size() - 1), "are there"},
      {"cut off, packed", "a.nii.gz", packed(good).substr(0, packed(good).size() - 20),
       "ends or is damaged after"},
      {"checksum cut off", "a.nii.gz", packed(good).substr(0, packed(good).size() - 5), "damaged"},
      {"wrong checksum", "a.nii.gz", flipped_bit, "damaged"},
      {"no whole numbers", "a.nii", halves, "a voxel has the value 2.5, which is no label"},
      {"probabilities", "a.nii", probabilities, "those of probabilities"},
      {"step as large as a label", "a.nii", coarse, "a voxel has the value 0.4"},
      {"not a number", "a.nii", not_a_number, "nan"},
      {"an image", "a.nii", negative, "value -1000: its values, from -1000"},
      {"label too large", "a.nii", large, "70000"},
      {"unknown extension", "a.img", good, "is no label map by its name"},
  };
}

std::vector<Case> nrrd_cases() {
  const LabelMap map = small_map();
  const std::string header = nrrd_header(map), raw = voxel_bytes<std::uint16_t>(map),
                    tail = "encoding: raw\n\n";
  const auto with = [&](const std::string& part, const std::string& other) {
    return replaced(header, part, other) + tail + raw;
  };
  return {
      {"no NRRD", "a.nrrd", "PNG" + header, "does not begin with 'NRRD000'"},
      {"no end of header", "a.nrrd", header, "does not end"},
      {"a line that is none", "a.nrrd", header + "nonsense\n" + tail + raw, "'nonsense'"},
      {"an endless line", "a.nrrd", header + "content: " + std::string(200'000, 'x') + "\n" + tail + raw,
       "200009 characters"},
      {"four dimensions", "a.nrrd", replaced(with("dimension: 3", "dimension: 4"), "6 5 4", "2 3 5 4"),
       "image of 4 dimensions"},
      {"a size missing", "a.nrrd", with("dimension: 3", "dimension: 4"), "not a size for each dimension"},
      {"two sizes", "a.nrrd", with("sizes: 6 5 4", "sizes: 6 5"), "three sizes"},
      {"size no number", "a.nrrd", with("sizes: 6 5 4", "sizes: 6 5 x"), "'x'"},
      {"16 GB", "a.nrrd", with("sizes: 6 5 4", "sizes: 2000 2000 500"), "are there"},
      {"overflowing size", "a.nrrd", with("sizes: 6 5 4", "sizes: 9223372036854775807 2 2"), "can hold"},
      {"sizes twice", "a.nrrd", with("kinds:", "sizes: 1 1 1\nkinds:"), "'sizes' twice"},
      {"no type", "a.nrrd", with("type: unsigned short\n", ""), "no 'type'"},
      {"block type", "a.nrrd", with("type: unsigned short", "type: block"), "'block'"},
      {"no byte order", "a.nrrd", with("endian: little\n", ""), "no 'endian'"},
      {"no space", "a.nrrd", with("space: left-posterior-superior\n", ""), "how it is oriented"},
      {"scanner space", "a.nrrd", with("left-posterior-superior", "scanner-xyz"), "'scanner-xyz'"},
      {"no directions", "a.nrrd", with("space directions", "thicknesses"), "no 'spacedirections'"},
      {"direction none", "a.nrrd", with("(0,1,0)", "none"), "as spacedirections"},
      {"origin not a number", "a.nrrd", with("space origin: (", "space origin: (nan,"), "as spaceorigin"},
      {"metres", "a.nrrd", with("kinds:", "space units: \"m\" \"m\" \"m\"\nkinds:"), "'m'"},
      {"text", "a.nrrd", header + "encoding: ascii\n\n1 2 3", "'ascii'"},
      {"byte skip", "a.nrrd", header + "line skip: 1\n" + tail + raw, "line skip"},
      {"data file not there", "a.nhdr", header + "encoding: raw\ndata file: none.raw\n",
       "which is not there"},
      {"many data files", "a.nhdr", header + "encoding: raw\ndata file: s%03d.raw 1 4 1\n",
       "'s001.raw', which is not there"},
      {"another folder", "a.nhdr", header + "encoding: raw\ndata file: LIST\n../a.raw\n", "outside its own"},
      {"another pattern", "a.nhdr", header + "encoding: raw\ndata file: s%x.raw 1 4\n", "by the pattern"},
      {"endless pattern", "a.nhdr", header + "encoding: raw\ndata file: s%d.raw 1 9999999999\n",
       "by the pattern"},
      {"cut off", "a.nrrd", (header + tail + raw).substr(0, header.size() + tail.size() + 50), "are there"},
      {"compressed data that are none", "a.nrrd", header + "encoding: gzip\n\n" + raw.substr(1), "are there"},
  };
}

std::vector<Case> meta_cases() {
  const LabelMap map = small_map();
  const std::string header = meta_header(map), raw = voxel_bytes<std::uint16_t>(map),
                    tail = "ElementDataFile = LOCAL\n";
  const auto with = [&](const std::string& part, const std::string& other) {
    return replaced(header, part, other) + tail + raw;
  };
  const std::string zipped = packed(raw, false);
  return {
      {"no MetaImage", "a.mha", "hello\n" + header + tail + raw, "'hello'"},
      {"no end of header", "a.mha", header, "does not end"},
      {"no image", "a.mha", with("ObjectType = Image", "ObjectType = Tube"), "'Tube'"},
      {"four dimensions", "a.mha", replaced(with("NDims = 3", "NDims = 4"), "6 5 4", "6 5 2 2"),
       "image of 4 dimensions"},
      {"a size missing", "a.mha", with("NDims = 3", "NDims = 4"), "3 sizes for 4 dimensions"},
      {"size that overflows, data at the end", "a.mha",
       replaced(with("NDims = 3", "NDims = 3\nHeaderSize = -1"), "6 5 4", "9223372036854775807 2 2"),
       "can hold"},
      {"more than there is at the end", "a.mha",
       replaced(with("NDims = 3", "NDims = 3\nHeaderSize = -1"), "6 5 4", "600 5 4"), "are there"},
      {"colours", "a.mha", with("NDims = 3", "NDims = 3\nElementNumberOfChannels = 3"), "3 numbers a voxel"},
      {"16 GB", "a.mha", with("DimSize = 6 5 4", "DimSize = 2000 2000 500"), "are there"},
      {"type", "a.mha", with("MET_USHORT", "MET_STRING"), "'MET_STRING'"},
      {"text", "a.mha", with("BinaryData = True", "BinaryData = False"), "written as text"},
      {"header size", "a.mha", with("NDims = 3", "NDims = 3\nHeaderSize = -2"), "HeaderSize"},
      {"matrix too short", "a.mha", with("TransformMatrix = 1", "TransformMatrix ="), "not 9 numbers"},
      {"zero spacing", "a.mha", with("ElementSpacing = 1", "ElementSpacing = 0"), "voxels measure 0"},
      {"list of files", "a.mhd", header + "ElementDataFile = LIST\na.raw\n", "'a.raw', which is not there"},
      {"list that is empty", "a.mhd", header + "ElementDataFile = LIST\n", "list of data files is empty"},
      {"list outside", "a.mhd", header + "ElementDataFile = LIST\n/etc/passwd\n", "outside its own folder"},
      {"data file not there", "a.mhd", header + "ElementDataFile = none.raw\n", "which is not there"},
      {"cut off", "a.mha", header + tail + raw.substr(0, 30), "are there"},
      {"cut off, compressed", "a.mha",
       header + "CompressedData = True\n" + tail + zipped.substr(0, zipped.size() - 8), "damaged"},
  };
}

TEST(MalformedLabelMap, EachDefectIsNamedWithTheFile) {
  const TemporaryFolder folder;
  for (const auto& cases : {nifti_cases(), nrrd_cases(), meta_cases()})
    for (const Case& c : cases) {
      SCOPED_TRACE(c.name + ": " + c.what);
      const auto path = folder.file(c.name, c.bytes);
      try {
        read_label_map(path);
        ADD_FAILURE() << "read without complaint";
      } catch (const IoError& e) {
        EXPECT_THAT(e.what(), HasSubstr(c.message));
        EXPECT_THAT(e.what(), HasSubstr(path.string()));
        EXPECT_THAT(e.what(), HasSubstr("; ")) << "no remedy";
      }
    }
}

TEST(MalformedLabelMap, CutOffAnywhereIsAnError) {
  const TemporaryFolder folder;
  const LabelMap map = small_map();
  const std::string raw = voxel_bytes<std::uint16_t>(map);
  const std::pair<std::string, std::string> files[] = {
      {"a.nii", nifti_bytes(map)},
      {"a.nii.gz", packed(nifti_bytes(map))},
      {"a.nrrd", nrrd_header(map) + "encoding: gzip\n\n" + packed(raw)},
      {"a.mha", meta_header(map) + "CompressedData = True\nElementDataFile = LOCAL\n" + packed(raw, false)}};
  for (const auto& [name, bytes] : files) {
    EXPECT_NO_THROW(read_label_map(folder.file(name, bytes)));
    for (std::size_t length = 0; length < bytes.size(); length += 7)
      EXPECT_THROW(read_label_map(folder.file(name, bytes.substr(0, length))), IoError)
          << name << " " << length;
  }
}

TEST(MalformedLabelMap, WhatIsNoFile) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_label_map(folder.file("none.nii.gz")), IoError);
  std::filesystem::create_directory(folder.path() / "folder.nrrd");
  EXPECT_THROW(read_label_map(folder.path() / "folder.nrrd"), IoError);
}

}  // namespace
}  // namespace foramen
