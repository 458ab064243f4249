#include "workflow/build_choices.hpp"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/option_bytes.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "workflow/label_choices.hpp"

namespace foramen {
namespace {

std::string all_bytes(const BuildChoices& choices) {
  return option_bytes(build_options(choices)) + option_bytes(evaluation_options(choices));
}

std::string without_effect(const BuildChoices& choices) {
  try {
    build_options(choices);
  } catch (const ChoiceWithoutEffect& e) {
    EXPECT_THAT(e.what(), testing::StartsWith(e.name()));
    return e.name();
  }
  return {};
}

TEST(BuildChoices, NothingChosenIsTheStagesOwnDefaults) {
  EXPECT_EQ(option_bytes(build_options({})), option_bytes(BuildOptions{}));
  EXPECT_EQ(option_bytes(evaluation_options({})), option_bytes(EvaluationOptions{}));
}

TEST(BuildChoices, TheDefaultsChosenByNameChangeNothing) {
  EXPECT_EQ(all_bytes(default_choices()), all_bytes({}));
}

TEST(BuildChoices, EveryChoiceChangesTheOptions) {
  const std::vector<BuildChoices> all = {{.method = Method::icp},
                                         {.objective = ObjectiveChoice::neighbours},
                                         {.objective = ObjectiveChoice::description},
                                         {.rounds = 1},
                                         {.distortion = DistortionMeasure::in_plane},
                                         {.bending = Bending::rigid},
                                         {.reference = "L1"},
                                         {.lambda = 0.7},
                                         {.landmarks = 400},
                                         {.target_error_mm = 0.4},
                                         {.samples = 5},
                                         {.seed = 3},
                                         {.scale = ScaleMode::remove},
                                         {.weights = LandmarkWeights::area},
                                         {.paper = true},
                                         {.initial_map = InitialMap::rectangle},
                                         {.optimiser = Optimiser::polak_ribiere}};
  std::set<std::string> seen = {all_bytes({})};
  for (const BuildChoices& choices : all) EXPECT_TRUE(seen.insert(all_bytes(choices)).second);
}

TEST(BuildChoices, LambdaIsThatOfTheObjectiveInUse) {
  const BuildOptions defaults;
  const auto lambdas = [](const BuildChoices& choices) {
    const CorrespondOptions how = build_options(choices).correspondence;
    return std::pair(how.group.lambda, how.registration.lambda);
  };
  const double group = defaults.correspondence.group.lambda;
  EXPECT_EQ(lambdas({.lambda = 0.7}), std::pair(0.7, defaults.correspondence.registration.lambda));
  EXPECT_EQ(lambdas({.objective = ObjectiveChoice::neighbours, .lambda = 0.7}), std::pair(group, 0.7));
  EXPECT_EQ(lambdas({.paper = true}), std::pair(group, paper_options().lambda));
}

TEST(BuildChoices, WhatIsNamedOverridesThePaper) {
  const BuildChoices choices{.objective = ObjectiveChoice::surface, .rounds = 2, .paper = true};
  EXPECT_EQ(build_options(choices).correspondence.objective, Objective::surface);
  EXPECT_EQ(build_options(choices).correspondence.group.round_limit, 2);
}

TEST(BuildChoices, ChoicesWithoutEffectAreRefused) {
  EXPECT_EQ(without_effect({.method = Method::icp, .rounds = 1}), "rounds");
  EXPECT_EQ(without_effect({.bending = Bending::rigid, .paper = true}), "bending");
  EXPECT_EQ(
      without_effect({.objective = ObjectiveChoice::neighbours, .distortion = DistortionMeasure::in_plane}),
      "distortion");
  EXPECT_EQ(without_effect({.landmarks = 400, .target_error_mm = 1}), "landmarks");
}

TEST(BuildChoices, NumbersOutOfTheirRangeAreRefused) {
  EXPECT_THROW(build_options({.landmarks = 3}), InvalidInput);
  EXPECT_THROW(build_options({.lambda = 0}), InvalidInput);
}

TEST(LabelChoices, NothingChosenAsksForNothing) { EXPECT_FALSE(label_request({}).has_value()); }

TEST(LabelChoices, WhatIsChosenIsAskedFor) {
  const auto request =
      label_request({.numbering = LabelNumbering::totalsegmentator, .labels = "27-31", .keep_cut = true});
  ASSERT_TRUE(request.has_value());
  EXPECT_EQ(request->numbering, LabelNumbering::totalsegmentator);
  EXPECT_FALSE(request->names);
  EXPECT_TRUE(request->labels.value().contains(28));
  EXPECT_TRUE(request->surface.keep_cut);
}

TEST(LabelChoices, TwoKindsOfNamesAreRefused) {
  EXPECT_THROW(label_request({.numbering = LabelNumbering::verse, .names_file = "names.csv"}), InvalidInput);
  EXPECT_THROW(label_request({.labels = "24-20"}), InvalidInput);
}

}  // namespace
}  // namespace foramen
