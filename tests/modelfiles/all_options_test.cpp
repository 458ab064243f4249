// Requirements for the options of every struct that affects a result.

#include <set>

#include <gtest/gtest.h>

#include "core/option_bytes.hpp"
#include "foramen/apply/complete_surface.hpp"
#include "foramen/core/options.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "foramen/evaluate/evaluate.hpp"
#include "foramen/extract/extract_label.hpp"
#include "foramen/match/bending_options.hpp"
#include "foramen/repair/repair_mesh.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "foramen/stages/build_model.hpp"
#include "foramen/synth/synth_cohort.hpp"
#include "modelfiles/options_json.hpp"

namespace foramen {
namespace {

/// Converts to any type, for expressions that are not evaluated.
struct AnyValue {
  template <class T>
  operator T() const;  // NOLINT(google-explicit-constructor)
};

template <class Struct, std::size_t... fields>
constexpr bool takes(std::index_sequence<fields...>) {
  return requires { Struct{((void)fields, AnyValue{})...}; };
}

/// The number of fields of an aggregate: the largest number of values from which it can be initialised.
template <class Struct, std::size_t tried = 40>
constexpr std::size_t field_count() {
  if constexpr (takes<Struct>(std::make_index_sequence<tried>{}))
    return tried;
  else
    return field_count<Struct, tried - 1>();
}

template <class Number>
requires std::is_arithmetic_v<Number>
void change(Number& number) {
  if constexpr (std::is_same_v<Number, bool>)
    number = !number;
  else if constexpr (std::is_floating_point_v<Number>)
    number = std::nextafter(number, std::numeric_limits<Number>::infinity());
  else
    ++number;
}
template <class Enum>
requires std::is_enum_v<Enum>
void change(Enum& value) {
  for (const auto& [word, other] : EnumWords<Enum>::all)
    if (other != value) {
      value = other;
      return;
    }
}
void change(std::string& text) { text += "x"; }
template <class Value>
void change(std::optional<Value>& value) {
  if (value)
    change(*value);
  else
    value.emplace();
}

template <DescribedOptions Options>
void change_option(Options& options, int which);

template <class Item>
void change(std::vector<Item>& list) {
  if constexpr (DescribedOptions<Item>)
    change_option(list.back(), 0);
  else
    change(list.back());
}

/// Changes the option with index `which` among those of the struct and its nested structs.
template <DescribedOptions Options>
void change_option(Options& options, int which) {
  for_each_option(options, [&](const std::string&, auto& field, const OptionText&) {
    if (which-- == 0) change(field);
  });
}

template <class Options>
class EveryOption : public ::testing::Test {
 protected:
  static std::vector<std::string> paths() {
    std::vector<std::string> all;
    const Options options{};
    for_each_option(options,
                    [&](const std::string& path, const auto&, const OptionText&) { all.push_back(path); });
    return all;
  }
};

using AllOptions =
    ::testing::Types<BuildOptions, CorrespondOptions, RegisterOptions, SoftNeighboursOptions,
                     RegisterGroupOptions, TemplateOptions, SmoothDisplacementOptions, DisplacementScale,
                     CohortPriorOptions, DeformTemplateOptions, SurfaceTargetsOptions,
                     DescriptionLengthOptions, PlaceLandmarksOptions, LandmarkSpreadOptions, RemeshOptions,
                     CurvatureDensityOptions, ErrorDensityOptions, ShapeModelOptions, EvaluationOptions,
                     RepairOptions, RemoveHandlesOptions, ExtractOptions, SynthOptions, MatchOptions,
                     AlignOptions, AlignPartOptions, CompleteSurfaceOptions, GeneralizationOptions>;
TYPED_TEST_SUITE(EveryOption, AllOptions);

TYPED_TEST(EveryOption, IsDescribed) {
  int described = 0;
  const auto count = [&](auto&, const OptionText&) { ++described; };
  TypeParam options;
  describe(count, options);
  EXPECT_EQ(described, field_count<TypeParam>());
}

TYPED_TEST(EveryOption, HasAMeaningAndAPathOfItsOwn) {
  std::set<std::string> seen;
  const TypeParam options{};
  for_each_option(options, [&](const std::string& path, const auto&, const OptionText& text) {
    EXPECT_FALSE(text.name.empty()) << path;
    EXPECT_FALSE(text.meaning.empty()) << path;
    EXPECT_TRUE(seen.insert(path).second) << path << " is the path of two options";
  });
}

TYPED_TEST(EveryOption, HasADefaultWithinItsRange) {
  EXPECT_NO_THROW(check_options("defaults", TypeParam{}));
}

TYPED_TEST(EveryOption, ChangesTheKey) {
  const std::vector<std::string> paths = this->paths();
  std::set<std::string> keys{option_bytes(TypeParam{})};
  for (std::size_t i = 0; i < paths.size(); ++i) {
    TypeParam changed;
    change_option(changed, static_cast<int>(i));
    EXPECT_TRUE(keys.insert(option_bytes(changed)).second) << paths[i];
  }
}

TEST(OptionsJson, NamesAreThoseThatRunJsonHadBefore) {
  const nlohmann::ordered_json group = described_json(RegisterGroupOptions{});
  for (const char* name :
       {"lambda_mm2", "rounds", "still_mm", "description_cut_mm2", "template_vertices", "displacement_scales",
        "displacement_functions_limit", "cohort_independent_area_mm2", "targets_reach_mm"})
    EXPECT_TRUE(group.contains(name)) << name;
  EXPECT_EQ(group["displacement_scales"][1],
            (nlohmann::ordered_json{{"length_mm", 20}, {"amplitude_mm", 1.5}}));
  EXPECT_EQ(group["bending_again"]["noise_mm"], (nlohmann::ordered_json{1, 0.5, 0.25}));
  EXPECT_EQ(group["bending_again"]["rejection_medians"], 4);
  EXPECT_EQ(group["distortion"], "template");
  const nlohmann::ordered_json landmarks = described_json(PlaceLandmarksOptions{});
  EXPECT_TRUE(landmarks.at("target_error_mm").is_null());
  EXPECT_EQ(landmarks.at("resampling").at("density_floor"), 0.15);
}

TEST(OptionsJson, AreReadAsTheyWereWritten) {
  const EvaluationOptions options{.scale = ScaleMode::remove,
                                  .weights = LandmarkWeights::area,
                                  .draws = 7,
                                  .samples = 8,
                                  .seed = 1234567890123456789};
  EvaluationOptions read;
  set_options(read, described_json(options));
  EXPECT_EQ(option_bytes(read), option_bytes(options));
  nlohmann::ordered_json wrong = described_json(options);
  wrong["scale"] = "shrink";
  EXPECT_THROW(set_options(read, wrong), InvalidInput);
  wrong.erase("scale");
  EXPECT_THROW(set_options(read, wrong), nlohmann::json::exception);
}

}  // namespace
}  // namespace foramen
