// What label maps themselves call their labels.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/io/label_map.hpp"
#include "support/label_maps.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using namespace testing;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::string replaced(std::string text, const std::string& part, const std::string& other) {
  return text.replace(text.find(part), part.size(), other);
}

// Columns of the labels 0, 1 and 2.
LabelMap small_map() {
  return labelled_lattice({3, 2, 2}, Vec3(1, 2, 3).asDiagonal(),
                          [](const Vec3& p) { return static_cast<int>(std::lround(p.x())) + 1; });
}

std::string segment(int number, const std::string& name, int label, int layer) {
  const std::string key = "Segment" + std::to_string(number) + "_";
  return key + "LabelValue:=" + std::to_string(label) + "\n" + key + "Layer:=" + std::to_string(layer) +
         "\n" + key + "Name:=" + name + "\n" + key + "Tags:=" + std::string(3000, 't') + "\n";
}

class SegmentNames : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
};

TEST_F(SegmentNames, SegmentsOfSlicer) {
  const LabelMap map = small_map();
  const auto file =
      folder_.file("p.seg.nrrd", nrrd_header(map) + segment(0, "L1 vertebra", 1, 0) + segment(1, "L2", 2, 0) +
                                     "Segment2_Name:=without a label\nencoding: raw\n\n" +
                                     voxel_bytes<std::uint16_t>(map));
  const LabelMap read = read_label_map(file);
  EXPECT_THAT(read.names, ElementsAre(std::pair(1, "L1 vertebra"), std::pair(2, "L2")));
  EXPECT_EQ(read.labels, map.labels);
  EXPECT_EQ(label_map_stem(file), "p");
}

TEST_F(SegmentNames, LayersOfSlicer) {
  const LabelMap map = small_map();
  std::string header = replaced(nrrd_header(map), "dimension: 3", "dimension: 4");
  header = replaced(header, "sizes: ", "sizes: 2 ");
  header = replaced(header, "space directions: ", "space directions: none ");
  header = replaced(header, "kinds: ", "kinds: list ");
  std::string voxels;  // the second layer has the label 1 where the first one has 2
  for (const std::uint16_t label : map.labels) {
    append_value(voxels, label);
    append_value(voxels, static_cast<std::uint16_t>(label == 2 ? 1 : 0));
  }
  const std::string names = segment(0, "L1", 1, 0) + segment(1, "L2", 1, 1);
  const auto file = folder_.file("p.seg.nrrd", header + names + "encoding: gzip\n\n" + packed(voxels));
  const auto layers = read_label_layers(file);
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_EQ(layers[0].labels, map.labels);
  EXPECT_EQ(layers[0].axes, map.axes);
  EXPECT_THAT(layers[0].names, ElementsAre(std::pair(1, "L1")));
  EXPECT_THAT(layers[1].names, ElementsAre(std::pair(1, "L2")));
  for (std::size_t i = 0; i < map.labels.size(); ++i)
    EXPECT_EQ(layers[1].labels[i], map.labels[i] == 2 ? 1 : 0);
  EXPECT_THAT(refusal([&] { read_label_map(file); }), says("2 layers"));
  // Cut off, and a number of layers that no file has.
  EXPECT_THAT(refusal([&] {
                read_label_layers(folder_.file("cut.seg.nrrd",
                                               header + names + "encoding: raw\n\n" + voxels.substr(0, 40)));
              }),
              says("40 are there"));
  EXPECT_THAT(
      refusal([&] {
        read_label_layers(folder_.file("many.seg.nrrd", replaced(header, "sizes: 2 ", "sizes: 99999 ") +
                                                            names + "encoding: raw\n\n" + voxels));
      }),
      says("99999 layers"));
}

TEST_F(SegmentNames, FourDimensionsWithoutSegmentsAreRefused) {
  const LabelMap map = small_map();
  std::string header = replaced(nrrd_header(map), "dimension: 3", "dimension: 4");
  header = replaced(header, "sizes: ", "sizes: 2 ");
  header = replaced(header, "space directions: ", "space directions: none ");
  EXPECT_THAT(refusal([&] { read_label_layers(folder_.file("a.nrrd", header + "encoding: raw\n\n")); }),
              says("image of 4 dimensions"));
}

// The map with this header extension, as NIfTI.
std::string nifti_with_extension(const LabelMap& map, std::string content, std::int32_t stated_size = 0) {
  content.resize((content.size() + 8 + 15) / 16 * 16 - 8, '\0');
  std::string bytes = nifti_bytes(map);
  std::string extension;
  append_value<std::int32_t>(extension,
                             stated_size != 0 ? stated_size : static_cast<std::int32_t>(content.size() + 8));
  append_value<std::int32_t>(extension, 0);
  extension += content;
  bytes[348] = 1;
  set_value<float>(bytes, 108, static_cast<float>(352 + extension.size()));
  return bytes.insert(352, extension);
}

const char* const table =
    R"(<?xml version="1.0" encoding="UTF-8"?> <CaretExtension>  <VolumeInformation Index="0">   <LabelTable>
<Label Key="1" Red="1" Green="0" Blue="0" Alpha="1"><![CDATA[vertebrae_L1]]></Label>
<Label Key="2" Red="1" Green="0" Blue="0" Alpha="1"><![CDATA[vertebrae_L2]]></Label>
  </LabelTable>   </VolumeInformation></CaretExtension>)";

TEST_F(SegmentNames, TheTableOfLabelsInNifti) {
  const LabelMap map = small_map();
  for (const char* name : {"a.nii", "a.nii.gz"}) {
    const std::string bytes = nifti_with_extension(map, table);
    const LabelMap read =
        read_label_map(folder_.file(name, std::string(name).ends_with("gz") ? packed(bytes) : bytes));
    EXPECT_THAT(read.names, ElementsAre(std::pair(1, "vertebrae_L1"), std::pair(2, "vertebrae_L2"))) << name;
    EXPECT_EQ(read.labels, map.labels);
  }
}

TEST_F(SegmentNames, ExtensionsThatCannotBeReadNameNothing) {
  const LabelMap map = small_map();
  const std::string whole = table;
  for (const std::string& bytes :
       {nifti_with_extension(map, whole.substr(0, 200)), nifti_with_extension(map, whole, 1'000'000),
        nifti_with_extension(map, whole, -5), nifti_with_extension(map, "something else")}) {
    const LabelMap read = read_label_map(folder_.file("a.nii", bytes));
    EXPECT_THAT(read.names, IsEmpty());
    EXPECT_EQ(read.labels, map.labels);
  }
}

}  // namespace
}  // namespace foramen
