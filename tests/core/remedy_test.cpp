#include "foramen/core/remedy.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

const std::vector<Remedy> both = {{RemedyKind::repair}, {RemedyKind::give_unit, "cm"}};

template <class Kind>
class ErrorOf : public ::testing::Test {};
using Kinds = ::testing::Types<Error, IoError, InvalidInput, TopologyError, ConvergenceError>;
TYPED_TEST_SUITE(ErrorOf, Kinds);

TYPED_TEST(ErrorOf, ArrivesWithItsRemediesAndItsTextAlone) {
  try {
    throw TypeParam("genus 3", both);
  } catch (const std::exception& e) {
    EXPECT_STREQ(e.what(), "genus 3");
    EXPECT_EQ(message_of(e).text, "genus 3");
    EXPECT_EQ(message_of(e).remedies, both);
  }
  const TypeParam again(Message("genus 3", both).about("L1.ply"));
  EXPECT_STREQ(again.what(), "L1.ply: genus 3");
  EXPECT_EQ(again.remedies(), both);
  EXPECT_TRUE(TypeParam("no remedy").remedies().empty());
}

TEST(MessageOf, AnErrorOfTheStandardLibraryHasNoRemedies) {
  const Message message = message_of(std::runtime_error("no memory"));
  EXPECT_EQ(message.text, "no memory");
  EXPECT_TRUE(message.remedies.empty());
}

TEST(MessageAppend, NamesEachRemedyOnce) {
  Message message("a", {{RemedyKind::give_unit, "cm"}});
  message.append({"b", both});
  message.append({"c", {{RemedyKind::give_unit, "m"}}});
  EXPECT_EQ(message.text, "abc");
  EXPECT_EQ(message.remedies,
            (std::vector<Remedy>{
                {RemedyKind::give_unit, "cm"}, {RemedyKind::repair}, {RemedyKind::give_unit, "m"}}));
}

TEST(Worded, ControlsFollowTheTextInTheirOrder) {
  const auto name_of = [](const Remedy& remedy) {
    return remedy.kind == RemedyKind::repair ? std::string("mend") : "unit " + remedy.value;
  };
  EXPECT_EQ(worded({"genus 3", both}, name_of), "genus 3 (mend; unit cm)");
  EXPECT_EQ(worded({"genus 3"}, name_of), "genus 3");
}

}  // namespace
}  // namespace foramen
