#include "core/kept_results.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "support/memory_store.hpp"

namespace foramen {
namespace {

class Kept : public ::testing::Test {
 protected:
  StageKey key(const std::string& stage, int part) const { return {ctx_, stage, part}; }
  const std::shared_ptr<testing::MemoryStore> store_ = std::make_shared<testing::MemoryStore>();
  const RunContext ctx_ = RunContext(1).with_store(store_);
};

TEST_F(Kept, IsComputedOnce) {
  int computed = 0;
  const auto work = [&] { return std::vector<int>{++computed}; };
  EXPECT_EQ(kept<std::vector<int>>(ctx_, key("a", 1), work), std::vector<int>{1});
  EXPECT_EQ(kept<std::vector<int>>(ctx_, key("a", 1), work), std::vector<int>{1});
  EXPECT_EQ(kept<std::vector<int>>(ctx_, key("b", 1), work), std::vector<int>{2}) << "another stage";
  EXPECT_EQ(kept<std::vector<int>>(ctx_, key("a", 2), work), std::vector<int>{3})
      << "made from something else";
  EXPECT_EQ(kept<std::vector<int>>(ctx_.with_threads(2), key("a", 1), work), std::vector<int>{1});
  EXPECT_EQ(kept<std::vector<int>>(RunContext(1), key("a", 1), work), std::vector<int>{4}) << "no store";
}

TEST_F(Kept, AnErrorThatFollowsFromTheInputIsKept) {
  int tried = 0;
  const auto fail = [&]() -> int {
    ++tried;
    throw TopologyError("genus 3", {{RemedyKind::repair}, {RemedyKind::give_unit, "cm"}});
  };
  for (int time = 0; time < 2; ++time) {
    try {
      kept<int>(ctx_, key("a", 1), fail);
      FAIL() << "no error";
    } catch (const TopologyError& e) {
      EXPECT_STREQ(e.what(), "genus 3");
      EXPECT_EQ(e.remedies(), (std::vector<Remedy>{{RemedyKind::repair}, {RemedyKind::give_unit, "cm"}}));
    }
  }
  EXPECT_EQ(tried, 1);
  const auto refuse = []() -> int { throw InvalidInput("too small"); };
  const auto diverge = []() -> int { throw ConvergenceError("no end"); };
  for (int time = 0; time < 2; ++time) {
    EXPECT_THROW(kept<int>(ctx_, key("a", 2), refuse), InvalidInput);
    EXPECT_THROW(kept<int>(ctx_, key("a", 3), diverge), ConvergenceError);
  }
  EXPECT_EQ(store_->size(), 3);
}

TEST_F(Kept, WhatMayNotComeAgainIsNotKept) {
  const auto stop = []() -> int { throw Cancelled(); };
  const auto full = []() -> int { throw IoError("disk full"); };
  const auto memory = []() -> int { throw std::bad_alloc(); };
  const auto defect = []() -> int { throw InternalError("ours"); };
  EXPECT_THROW(kept<int>(ctx_, key("a", 1), stop), Cancelled);
  EXPECT_THROW(kept<int>(ctx_, key("a", 1), full), IoError);
  EXPECT_THROW(kept<int>(ctx_, key("a", 1), memory), std::bad_alloc);
  EXPECT_THROW(kept<int>(ctx_, key("a", 1), defect), InternalError);
  EXPECT_EQ(store_->size(), 0);
}

TEST_F(Kept, AKeyStandsForTheResultItNames) {
  const StageKey one = key("a", 1), other = key("a", 2);
  EXPECT_EQ(StageKey(ctx_, "b", one), StageKey(ctx_, "b", one));
  EXPECT_NE(StageKey(ctx_, "b", one), StageKey(ctx_, "b", other));
  EXPECT_NE(StageKey(ctx_, "b", std::vector{one, other}), StageKey(ctx_, "b", std::vector{other, one}));
  EXPECT_EQ(StageKey(RunContext(1), "b", 1).text(), "") << "no store";
}

}  // namespace
}  // namespace foramen
