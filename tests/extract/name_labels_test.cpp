#include "extract/name_labels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/messages.hpp"

namespace foramen {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::offers;
using testing::says;

// One voxel a label, from head to foot.
LabelNaming named(const std::vector<int>& labels, const std::string& stem, const LabelRequest& request = {},
                  const std::map<int, std::string>& in_file = {}) {
  LabelMap map;
  map.size = {1, 1, static_cast<int>(labels.size())};
  for (auto label = labels.rbegin(); label != labels.rend(); ++label)
    map.labels.push_back(static_cast<std::uint16_t>(*label));
  map.names = in_file;
  return name_labels(map, find_labels(map), stem, request);
}

TEST(NameLabels, VerSeIsAssumedWithoutADoubtWhereItFits) {
  for (const std::vector<int>& labels : {std::vector{20, 21, 22, 23, 24},
                                         {8, 20},
                                         {20, 22, 24},
                                         {7, 8, 9},
                                         {19, 28, 20},
                                         {24, 25, 26},
                                         {21}}) {
    const LabelNaming naming = named(labels, "spine");
    EXPECT_EQ(naming.source, NameSource::assumed);
    EXPECT_EQ(naming.names, label_names(LabelNumbering::verse));
    EXPECT_THAT(naming.doubts, IsEmpty()) << labels.front();
  }
}

TEST(NameLabels, NumbersThatFitAnotherNumberingAreDoubted) {
  const auto doubts = [](const std::vector<int>& labels) { return named(labels, "spine").doubts; };
  EXPECT_THAT(doubts({22, 21}), ElementsAre(AllOf(says("totalsegmentator-v1 (21 is L2, 22 is L1)"),
                                                  says("verse, assumed (21 is L2, 22 is L3)"),
                                                  offers({{RemedyKind::name_labels}}))));
  EXPECT_THAT(doubts({31, 30, 29, 28, 27}), ElementsAre(says("fit the numbering totalsegmentator (")));
  EXPECT_THAT(doubts({41, 42}),
              ElementsAre(AllOf(says("totalspineseg (41 is L1, 42 is L2)"), says("names none of them"))));
  EXPECT_THAT(doubts({16, 17, 21, 22}), ElementsAre(says("totalspineseg (16 is C6"))) << "no gap there";
}

TEST(NameLabels, ANumberingThatWasGivenIsTakenAndDoubtedToo) {
  const LabelRequest request{.numbering = LabelNumbering::totalsegmentator};
  EXPECT_THAT(named({32, 31, 30}, "spine", request).doubts, IsEmpty());
  const LabelNaming naming = named({41, 42}, "spine", request);
  EXPECT_EQ(naming.names.at(41), "T3");
  EXPECT_THAT(naming.doubts, ElementsAre(AllOf(says("totalspineseg"), says("totalsegmentator ("))));
}

TEST(NameLabels, APartOfTheSpineInTheFilesNameCounts) {
  EXPECT_THAT(named({21, 22}, "sub-02_thoracic").doubts,
              ElementsAre(AllOf(says("verse, assumed (21 is L2, 22 is L3)"),
                                says("totalspineseg (21 is T1, 22 is T2)"))));
  EXPECT_THAT(named({21, 22}, "sub-02_lumbar").doubts, IsEmpty());
  EXPECT_THAT(named({19, 20}, "sub-02_thoracic").doubts, IsEmpty()) << "T12 is thoracic";
}

TEST(NameLabels, AMaskIsNamedByItsFile) {
  for (const int label : {1, 255}) {
    const LabelNaming naming = named({label}, "vertebrae_L1");
    EXPECT_EQ(naming.source, NameSource::file_name);
    EXPECT_THAT(naming.names, ElementsAre(std::pair(label, "L1")));
    EXPECT_THAT(naming.doubts, IsEmpty());
  }
  const LabelNaming given = named({1}, "vertebrae_L1", {.numbering = LabelNumbering::verse});
  EXPECT_EQ(given.names.at(1), "L1");
  EXPECT_THAT(given.doubts, ElementsAre(AllOf(says("C1 by verse"), says("file's name says L1"))));
}

TEST(NameLabels, ANameInTheFileThatIsNoLevelTellsLessThanTheFilesName) {
  EXPECT_EQ(named({1}, "vertebrae_L1", {}, {{1, "Segment_1"}}).names.at(1), "L1");
  const LabelNaming naming = named({1}, "vertebrae_L1", {}, {{1, "L2 vertebra"}});
  EXPECT_EQ(naming.names.at(1), "L2");
  EXPECT_THAT(naming.doubts, ElementsAre(AllOf(says("L2 by the names in the file"), says("says L1"))));
}

TEST(NameLabels, ALoneLabel1IsNeverC1Silently) {
  const LabelNaming naming = named({1}, "bone");
  EXPECT_EQ(naming.names.at(1), "label1");
  EXPECT_THAT(naming.doubts,
              ElementsAre(AllOf(says("C1"), says("label1"), offers({{RemedyKind::name_labels}}))));
  EXPECT_EQ(named({1}, "bone", {.numbering = LabelNumbering::verse}).names.at(1), "C1") << "if it is said";
}

TEST(NameLabels, AFileNameAgainstItsOnlyLabelIsDoubted) {
  const LabelNaming naming = named({22}, "verse005_L1");
  EXPECT_EQ(naming.names.at(22), "L3");
  EXPECT_THAT(naming.doubts, ElementsAre(AllOf(says("label 22 is L3"), says("says L1"))));
  EXPECT_THAT(named({20}, "verse005_L1").doubts, IsEmpty());
}

TEST(NameLabels, NamesInTheFileComeBeforeAnAssumption) {
  const LabelNaming naming =
      named({1, 2, 3}, "p", {}, {{1, "L1 vertebra"}, {2, "vertebrae_L2"}, {3, "liver"}});
  EXPECT_EQ(naming.source, NameSource::names_in_file);
  EXPECT_THAT(naming.names, ElementsAre(std::pair(1, "L1"), std::pair(2, "L2")));
  EXPECT_THAT(named({1, 2}, "p", {}, {{1, "left half"}, {2, "b"}}).names,
              ElementsAre(std::pair(1, "left_half"), std::pair(2, "b")))
      << "all of them if none is a vertebra";
}

TEST(NameLabels, NamesInTheFileAgainstWhatWasGivenAreDoubted) {
  const std::map<int, std::string> in_file{{20, "L2 vertebra"}, {21, "L2"}};
  const LabelNaming naming = named({20, 21}, "p", {.numbering = LabelNumbering::verse}, in_file);
  EXPECT_EQ(naming.names.at(20), "L1");
  EXPECT_THAT(naming.doubts, ElementsAre(says("label 20 is L1 by verse and 'L2 vertebra' in the file")));
  LabelRequest own;
  own.names = LabelNames{{21, "L3"}};
  EXPECT_THAT(named({21}, "p", own, in_file).doubts, ElementsAre(says("label 21 is L3 by the names given")));
}

}  // namespace
}  // namespace foramen
