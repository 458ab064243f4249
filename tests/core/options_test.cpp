#include "foramen/core/options.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/option_bytes.hpp"

namespace foramen {
namespace {

enum class Colour { red, dark_red };

struct Inner {
  double width_mm = 2;
  std::vector<double> levels = {3, 1};
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<Inner> auto& o) {
  visit(o.width_mm, {.name = "width", .unit = "mm", .range = above(0), .meaning = "how wide"});
  visit(o.levels, {.name = "levels", .range = at_least(0).up_to(5), .meaning = "how deep"});
}

struct Outer {
  int count = 4;
  bool loud = false;
  std::string name = "auto";
  std::optional<double> limit = std::nullopt;
  Inner a = {}, b = {}, c = {};
  std::vector<Inner> more = {{}};
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<Outer> auto& o) {
  visit(o.count, {.name = "count", .range = at_least(1), .meaning = "how many"});
  visit(o.loud, {.name = "loud", .meaning = "whether it is heard"});
  visit(o.name, {.name = "name", .meaning = "how it is called"});
  visit(o.limit, {.name = "limit", .unit = "mm^2", .range = above(0).below(1), .meaning = "where it ends"});
  visit(o.a, {.name = "a"});
  visit(o.b, {.name = "b", .nesting = Nesting::prefixed});
  visit(o.c, {.nesting = Nesting::inlined});
  visit(o.more, {.name = "more", .meaning = "further ones"});
}

TEST(OptionRange, ContainsWhatItsTextSays) {
  const double tiny = std::numeric_limits<double>::denorm_min(), nan = std::nan("");
  EXPECT_EQ(OptionRange{}.text(), "");
  EXPECT_TRUE(OptionRange{}.contains(-1e300));
  EXPECT_FALSE(OptionRange{}.contains(nan));
  EXPECT_EQ(above(0).text(), "> 0");
  EXPECT_TRUE(above(0).contains(tiny));
  EXPECT_FALSE(above(0).contains(0));
  EXPECT_FALSE(above(0).contains(nan));
  EXPECT_EQ(at_least(16).text(), "at least 16");
  EXPECT_TRUE(at_least(16).contains(16));
  EXPECT_FALSE(at_least(16).contains(std::nextafter(16.0, 0)));
  EXPECT_EQ(above(0).up_to(0.5).text(), "in (0, 0.5]");
  EXPECT_TRUE(above(0).up_to(0.5).contains(0.5));
  EXPECT_FALSE(above(0).up_to(0.5).contains(std::nextafter(0.5, 1)));
  EXPECT_EQ(at_least(-1).below(1000000).text(), "in [-1, 1000000)");
  EXPECT_FALSE(at_least(-1).below(1000000).contains(1000000));
}

TEST(Options, PathsFollowTheNesting) {
  std::vector<std::string> paths;
  const Outer options;
  for_each_option(options,
                  [&](const std::string& path, const auto&, const OptionText&) { paths.push_back(path); });
  EXPECT_THAT(paths, ::testing::ElementsAre("count", "loud", "name", "limit", "a.width", "a.levels",
                                            "b_width", "b_levels", "width", "levels", "more"));
}

TEST(Options, NamesCarryTheirUnit) {
  EXPECT_EQ(name_with_unit("reach", "mm"), "reach_mm");
  EXPECT_EQ(name_with_unit("lambda", "mm^2"), "lambda_mm2");
  EXPECT_EQ(name_with_unit("lambda", ""), "lambda");
}

TEST(Options, ANumberOutOfItsRangeIsNamedWithBoth) {
  const auto refused = [](const Outer& options) {
    try {
      check_options("paint", options);
    } catch (const InvalidInput& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_EQ(refused({}), "");
  EXPECT_EQ(refused({.count = 0}), "paint: count is 0; it must be at least 1");
  EXPECT_EQ(refused({.limit = 1}), "paint: limit is 1 mm^2; it must be in (0, 1)");
  EXPECT_EQ(refused({.limit = 0.5}), "");
  EXPECT_EQ(refused({.b = {.width_mm = -2}}), "paint: b_width is -2 mm; it must be > 0");
  EXPECT_EQ(refused({.a = {.levels = {1, 6}}}), "paint: a.levels is 6; it must be in [0, 5]");
  EXPECT_EQ(refused({.more = {{}, {.width_mm = std::nan("")}}}), "paint: width is nan mm; it must be > 0");
}

TEST(Options, BytesAreThoseOfTheValues) {
  EXPECT_EQ(option_bytes(Outer{}), option_bytes(Outer{}));
  EXPECT_NE(option_bytes(Outer{}), option_bytes(Outer{.limit = 0.5}));
  EXPECT_NE(option_bytes(Outer{.a = {.levels = {1, 2}}}), option_bytes(Outer{.a = {.levels = {1}}}));
  EXPECT_NE(option_bytes(Outer{.more = {}}), option_bytes(Outer{.more = {{}, {}}}));
  EXPECT_NE(option_bytes(Outer{.more = {{.width_mm = 1}}}), option_bytes(Outer{.more = {{.width_mm = 3}}}));
}

}  // namespace

template <>
struct EnumWords<Colour> {
  static constexpr std::pair<std::string_view, Colour> all[] = {{"red", Colour::red},
                                                                {"dark-red", Colour::dark_red}};
};

namespace {

TEST(Options, WordsAndValuesOfAnEnumeration) {
  EXPECT_EQ(word_of(Colour::dark_red), "dark-red");
  EXPECT_EQ(value_of<Colour>("red"), Colour::red);
  EXPECT_EQ(value_of<Colour>("Red"), std::nullopt);
}

}  // namespace
}  // namespace foramen
