#include "extract/vertebra_level.hpp"

#include <gtest/gtest.h>

namespace foramen {
namespace {

TEST(LevelOf, NamesOfOneVertebra) {
  for (const auto& [name, level] : {std::pair{"L1", "L1"},
                                    {"L1 vertebra", "L1"},
                                    {"vertebrae_L1", "L1"},
                                    {"Vertebra T12", "T12"},
                                    {"Th4", "T4"},
                                    {"lumbar vertebra L5", "L5"},
                                    {"first lumbar vertebra", "L1"},
                                    {"Lumbar vertebra 3", "L3"},
                                    {"Twelfth thoracic vertebra", "T12"},
                                    {"Sacrum", "sacrum"}})
    EXPECT_EQ(level_of(name), level) << name;
}

TEST(LevelOf, OtherStructuresHaveNone) {
  for (const char* name : {"", "Segment_1", "L1 left pedicle", "disc L1-L2", "L9", "rib_left_1", "lung", "C8",
                           "thoracic vertebra L1", "liver", "T1 image", "vertebra"})
    EXPECT_FALSE(level_of(name)) << name;
}

TEST(LevelInFileName, IsWhatTheOtherWordsLeave) {
  for (const auto& [stem, level, rest] : {std::tuple{"vertebrae_L1", "L1", ""},
                                          {"s0001_vertebrae_L1", "L1", "s0001"},
                                          {"sub-01_T12_mask", "T12", "sub-01"},
                                          {"s1_L2", "L2", "s1"},
                                          {"C2_vertebra_L3", "L3", "C2"},
                                          {"L4", "L4", ""}}) {
    const auto found = level_in_file_name(stem);
    ASSERT_TRUE(found) << stem;
    EXPECT_EQ(found->level, level) << stem;
    EXPECT_EQ(found->rest, rest) << stem;
  }
  for (const char* stem : {"spine", "L1-L2", "liver", "verse004"})
    EXPECT_FALSE(level_in_file_name(stem)) << stem;
}

TEST(RankOfLevel, GoesFromHeadToFoot) {
  const char* ordered[] = {"C1", "C7", "T1", "T12", "T13", "L1", "L5", "L6", "sacrum", "coccyx"};
  for (std::size_t i = 1; i < std::size(ordered); ++i)
    EXPECT_LT(*rank_of_level(ordered[i - 1]), *rank_of_level(ordered[i])) << ordered[i];
  EXPECT_EQ(*rank_of_level("T1") - *rank_of_level("C7"), 2);
  EXPECT_EQ(*rank_of_level("L1") - *rank_of_level("T12"), 2);
  EXPECT_EQ(*rank_of_level("sacrum") - *rank_of_level("L5"), 2);
  EXPECT_FALSE(rank_of_level("label1"));
}

}  // namespace
}  // namespace foramen
