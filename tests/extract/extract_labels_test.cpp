#include "extract/extract_labels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/label_maps.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using namespace testing;
using ::testing::AllOf;
using ::testing::Contains;

TEST(LabelSelection, SinglesAndRanges) {
  const LabelSelection selection = LabelSelection::parse("20-24,3,22");
  EXPECT_TRUE(selection.contains(3) && selection.contains(20) && selection.contains(24));
  EXPECT_FALSE(selection.contains(19) || selection.contains(25));
  EXPECT_TRUE(selection.named_singly(22)) << "also where a range has it too";
  EXPECT_FALSE(selection.named_singly(21));
  EXPECT_EQ(selection.text(), "20-24,3,22");
}

TEST(LabelSelection, WhatIsNoneIsNamed) {
  for (const char* text : {"", "20-", "-3", "x", "3,", "1-2-3", "0", "70000", "3 4", "1e1"})
    EXPECT_THAT(refusal([&] { LabelSelection::parse(text); }), says("whole numbers from 1 to 65535")) << text;
  EXPECT_THAT(refusal([] { LabelSelection::parse("24-20"); }), says("write 20-24"));
}

TEST(Listed, RunsAsRanges) {
  EXPECT_EQ(listed({1, 2, 3, 5, 7, 8}), "1-3, 5, 7, 8");
  EXPECT_EQ(listed({}), "");
}

TEST(LabelNames, BuiltInNumberings) {
  const LabelNames& verse = label_names(LabelNumbering::verse);
  EXPECT_EQ(verse.size(), 28u);
  for (const auto& [label, name] : {std::pair{1, "C1"},
                                    {7, "C7"},
                                    {8, "T1"},
                                    {19, "T12"},
                                    {20, "L1"},
                                    {24, "L5"},
                                    {25, "L6"},
                                    {26, "sacrum"},
                                    {27, "coccyx"},
                                    {28, "T13"}})
    EXPECT_EQ(name_of(verse, label), name);
  const LabelNames& total = label_names(LabelNumbering::totalsegmentator);
  EXPECT_EQ(total.size(), 26u);
  for (const auto& [label, name] : {std::pair{25, "sacrum"},
                                    {26, "S1"},
                                    {27, "L5"},
                                    {31, "L1"},
                                    {32, "T12"},
                                    {43, "T1"},
                                    {44, "C7"},
                                    {50, "C1"}})
    EXPECT_EQ(name_of(total, label), name);
  const LabelNames& first = label_names(LabelNumbering::totalsegmentator_v1);
  EXPECT_EQ(first.size(), 25u);
  for (const auto& [label, name] :
       {std::pair{18, "L5"}, {22, "L1"}, {23, "T12"}, {34, "T1"}, {35, "C7"}, {41, "C1"}, {92, "sacrum"}})
    EXPECT_EQ(name_of(first, label), name);
  const LabelNames& spine = label_names(LabelNumbering::totalspineseg);
  EXPECT_EQ(spine.size(), 25u);
  for (const auto& [label, name] :
       {std::pair{11, "C1"}, {17, "C7"}, {21, "T1"}, {32, "T12"}, {41, "L1"}, {45, "L5"}, {50, "sacrum"}})
    EXPECT_EQ(name_of(spine, label), name);
  EXPECT_EQ(name_of(verse, 37), "label37");
}

TEST(ReadLabelNames, FromCsv) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& rows) {
    return read_label_names(folder.file("n.csv", "label,name\n" + rows));
  };
  EXPECT_EQ(name_of(read("3,L1\n7,left_hip\n"), 7), "left_hip");
  EXPECT_THAT(refusal([&] { read("3,L1\nx,L2\n"); }), says("row 2: 'x'"));
  EXPECT_THAT(refusal([&] { read("0,L1\n"); }), says("'0' is no label"));
  EXPECT_THAT(refusal([&] { read("3,../x\n"); }), says("'../x' cannot be"));
  EXPECT_THAT(refusal([&] { read("3,\n"); }), says("'' cannot be"));
  EXPECT_THAT(refusal([&] { read("3,L1\n3,L2\n"); }), says("label 3 is there twice"));
  EXPECT_THAT(refusal([&] { read("3,L1\n4,L1\n"); }), says("'L1' is there twice"));
  EXPECT_THAT(refusal([&] { read_label_names(folder.file("m.csv", "number,name\n3,L1\n")); }), says("label"));
}

// Boxes of one label each, beside each other. The last one reaches the border.
class ExtractLabels : public ::testing::Test {
 protected:
  std::filesystem::path file(const std::vector<int>& labels) {
    const int count = static_cast<int>(labels.size());
    LabelMap map;
    map.size = {6 * count, 6, 6};
    for (int k = 0; k < 6; ++k)
      for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 6 * count; ++i) {
          const bool within = i % 6 > 0 && i % 6 < 5 && j > 0 && j < 5 && k > 0 && k < 5;
          map.labels.push_back(static_cast<std::uint16_t>(within ? labels[i / 6] : 0));
        }
    return folder_.file("spine.nii.gz", packed(nifti_bytes(map)));
  }
  static LabelRequest request(const char* labels) { return {.labels = LabelSelection::parse(labels)}; }
  TemporaryFolder folder_;
  RunContext ctx_{2};
};

TEST_F(ExtractLabels, StemsAreFileAndNameInOrderOfLabel) {
  const LabelSurfaces found = extract_labels(file({21, 8, 40}), request("1-50"), ctx_);
  ASSERT_EQ(found.surfaces.size(), 3u);
  EXPECT_EQ(found.surfaces[0].stem, "spine_T1");
  EXPECT_EQ(found.surfaces[1].stem, "spine_L2");
  EXPECT_EQ(found.surfaces[2].stem, "spine_label40");
  EXPECT_EQ(found.sha256.size(), 64u);
}

TEST_F(ExtractLabels, AbsentOnesOfARangeAreNotedAndSingleOnesRefused) {
  const LabelSurfaces found = extract_labels(file({20, 22}), request("20-24,3"), ctx_);
  EXPECT_EQ(found.surfaces.size(), 2u);
  ASSERT_EQ(found.refused.size(), 1u);
  EXPECT_EQ(found.refused[0].stem, "spine_C3");
  EXPECT_TRUE(found.refused[0].absent);
  EXPECT_THAT(found.refused[0].reason, says("it holds 20, 22"));
  EXPECT_THAT(found.notes, Contains(says("has no labels 21, 23, 24")));
}

TEST_F(ExtractLabels, WithoutASelectionAllThatHaveAName) {
  const LabelSurfaces found = extract_labels(file({20, 99}), {}, ctx_);
  EXPECT_EQ(found.surfaces.size(), 1u);
  EXPECT_THAT(found.notes, Contains(AllOf(says("label 99 has no name and was not taken"),
                                          offers({{RemedyKind::choose_labels}, {RemedyKind::name_labels}}))));
}

TEST_F(ExtractLabels, NothingWantedIsRefusedWithWhatThereIs) {
  EXPECT_THAT(
      refusal([&] {
        extract_labels(file({20, 21}), request("1-7"), ctx_);
      }),
      AllOf(says("holds none of the labels 1-7; it holds 20, 21"), offers({{RemedyKind::choose_labels}})));
  EXPECT_THAT(refusal([&] { extract_labels(file({0}), {}, ctx_); }), says("holds no label"));
  EXPECT_THAT(refusal([&] { extract_labels(file({99}), {}, ctx_); }), says("no label that has a name"));
}

TEST_F(ExtractLabels, EqualStemsAreRefused) {
  LabelRequest both = request("3-4");
  both.names = LabelNames{{3, "label4"}};
  EXPECT_THAT(refusal([&] { extract_labels(file({3, 4}), both, ctx_); }), says("spine_label4"));
}

}  // namespace
}  // namespace foramen
