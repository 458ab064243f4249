#include "findings/model_difference.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "findings/compare_models.hpp"
#include "modelfiles/metrics_file.hpp"
#include "support/temporary_folder.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Generalization and representation errors of one shape.
struct ShapeFigures {
  std::string name, subject;
  double hausdorff, mean_surface;
};

ErrorsAtModes errors(int modes, const std::vector<ShapeFigures>& shapes) {
  std::vector<ShapeError> items;
  for (const ShapeFigures& s : shapes) items.push_back({s.hausdorff, s.mean_surface, 0});
  return errors_at_modes(modes, items);
}

Evaluation evaluation(const std::vector<ShapeFigures>& shapes, const Estimate& specificity) {
  Evaluation e;
  for (const ShapeFigures& s : shapes) {
    e.names.push_back(s.name);
    e.subjects.push_back(s.subject);
    e.representation.shapes.push_back({.distance = {s.mean_surface, 2 * s.hausdorff, s.hausdorff}});
  }
  e.leave_one_out = {LeaveOut::shape, 3, {errors(1, shapes), errors(2, shapes)}};
  e.leave_subject_out = Generalization{LeaveOut::subject, 2, {errors(1, shapes)}};
  e.specificity.by_modes = {{1, {}, specificity, specificity, {}}, {5, {}, specificity, specificity, {}}};
  return e;
}

// The shapes of the second model have another order. Differences of a, b, c: Hausdorff 1, 2, 3; mean surface
// 1, 2, -4.
const Evaluation first = evaluation({{"a", "s", 10, 1}, {"b", "s", 20, 2}, {"c", "t", 30, 9}}, {7, 3});
const Evaluation second = evaluation({{"c", "t", 33, 5}, {"a", "s", 11, 2}, {"b", "s", 22, 4}}, {9, 4});

const DifferenceGroup& group(const ModelDifference& difference, std::string_view name) {
  for (const DifferenceGroup& g : difference.groups)
    if (g.name == name) return g;
  throw std::runtime_error("no " + std::string(name));
}

TEST(ModelDifference, PairsShapesByName) {
  const ModelDifference d = model_difference({"A", &first}, {"B", &second});
  EXPECT_EQ(d.why_not_paired, "");
  const DifferenceGroup& g = group(d, "Generalization (leave one out)");
  ASSERT_EQ(g.measures.size(), 2u);
  for (const DifferenceAtModes& at : g.measures[0].by_modes) {
    EXPECT_DOUBLE_EQ(at.difference.mean, 2);
    EXPECT_DOUBLE_EQ(at.difference.standard_error, 1 / std::sqrt(3));
    EXPECT_EQ(at.p_value, 0.25);  // all of one sign: 2 of 8
  }
  EXPECT_EQ(g.measures[0].by_modes[1].modes, 2);
  EXPECT_NEAR(g.measures[1].by_modes[0].difference.mean, -1.0 / 3, 1e-15);
  EXPECT_EQ(g.measures[1].by_modes[0].p_value, 1);  // |1 + 2 - 4| is the least there is

  const DifferenceGroup& r = group(d, "Representation");
  EXPECT_EQ(r.measures[0].by_modes[0].p_value, 1);                 // mean surface
  EXPECT_DOUBLE_EQ(r.measures[1].by_modes[0].difference.mean, 4);  // p95
  EXPECT_EQ(r.measures[2].by_modes[0].p_value, 0.25);              // Hausdorff
  EXPECT_FALSE(r.measures[0].by_modes[0].modes.has_value());
}

TEST(ModelDifference, IsItsOppositeTheOtherWayRound) {
  const ModelDifference here = model_difference({"A", &first}, {"B", &second});
  const ModelDifference there = model_difference({"B", &second}, {"A", &first});
  for (std::size_t g = 0; g < here.groups.size(); ++g)
    for (std::size_t m = 0; m < here.groups[g].measures.size(); ++m)
      for (std::size_t k = 0; k < here.groups[g].measures[m].by_modes.size(); ++k) {
        const DifferenceAtModes &a = here.groups[g].measures[m].by_modes[k],
                                &b = there.groups[g].measures[m].by_modes[k];
        EXPECT_DOUBLE_EQ(a.difference.mean, -b.difference.mean);
        EXPECT_DOUBLE_EQ(a.difference.standard_error, b.difference.standard_error);
        EXPECT_EQ(a.p_value, b.p_value);
      }
}

TEST(ModelDifference, ShapesOfASubjectChangeSignTogether) {
  const std::string name = "Generalization (leave one subject out)";
  const ModelDifference d = model_difference({"A", &first}, {"B", &second});
  const DifferenceGroup& g = group(d, name);
  EXPECT_DOUBLE_EQ(g.measures[0].by_modes[0].difference.mean, 2);
  EXPECT_EQ(g.measures[0].by_modes[0].p_value, 0.5);  // sums 3 and 3
  EXPECT_EQ(g.measures[1].by_modes[0].p_value, 1);    // sums 3 and -4

  Evaluation other = second;
  other.subjects = {"t", "s", "t"};
  for (const DifferenceGroup& found : model_difference({"A", &first}, {"B", &other}).groups)
    EXPECT_NE(found.name, name) << "the two do not know the same subjects";
}

TEST(ModelDifference, SpecificityHasTheTwoSampleStandardErrorAtCommonModes) {
  Evaluation other = second;
  other.specificity.by_modes[1].modes = 4;
  const ModelDifference d = model_difference({"A", &first}, {"B", &other});
  const DifferenceGroup& g = group(d, "Specificity");
  ASSERT_EQ(g.measures[0].by_modes.size(), 1u);
  EXPECT_DOUBLE_EQ(g.measures[0].by_modes[0].difference.mean, 2);
  EXPECT_DOUBLE_EQ(g.measures[0].by_modes[0].difference.standard_error, 5);  // of 3 and 4
  EXPECT_FALSE(g.measures[0].by_modes[0].p_value.has_value());
}

// Marks on all ordered pairs of different subjects; a pair's value is that of its second shape.
Evaluation marked(Evaluation e, const std::vector<double>& of_shape) {
  e.marks.emplace();
  e.regions.emplace();
  for (int from = 0; from < 3; ++from)
    for (int to = 0; to < 3; ++to) {
      if (e.subjects[from] == e.subjects[to]) continue;
      e.marks->pairs.push_back({from, to, of_shape[to], std::nullopt});
      e.regions->pairs.push_back({from, to, of_shape[to] / 10});
    }
  return e;
}

TEST(ModelDifference, MarksArePairedOverPairsOfShapes) {
  // The shapes of the second model have another order: c, a, b.
  const Evaluation here = marked(first, {1, 2, 3}), there = marked(second, {5, 0.5, 2.5});
  const ModelDifference d = model_difference({"A", &here}, {"B", &there});
  const DifferenceGroup& points = group(d, "Marks, points");
  const DifferenceAtModes& at = points.measures.at(0).by_modes.at(0);
  // From a and b to c +2 each, from c to a -0.5 and to b +0.5.
  EXPECT_DOUBLE_EQ(at.difference.mean, 1);
  EXPECT_TRUE(std::isnan(at.difference.standard_error)) << "there are two subjects";
  EXPECT_EQ(at.p_value, 1);  // sums 4 and 0
  EXPECT_THAT(points.note, HasSubstr("over 4 ordered pairs, mm; the second is better in 1;"));
  const DifferenceGroup& regions = group(d, "Regions");
  EXPECT_DOUBLE_EQ(regions.measures[0].by_modes[0].difference.mean, 0.1);
  EXPECT_THAT(regions.note, HasSubstr("the second is better in 3;"));
  for (const DifferenceGroup& g : d.groups) EXPECT_NE(g.name, "Marks, curves");
  const auto json = difference_json(d);
  const auto regions_row = json.at("second_minus_first").at(json.at("second_minus_first").size() - 5);
  EXPECT_EQ(regions_row.at("measure"), "Regions, Dice");
  EXPECT_NEAR(regions_row.at("mean_share").get<double>(), 0.1, 1e-15);
  EXPECT_TRUE(nlohmann::json::parse(regions_row.dump()).at("standard_error_share").is_null());
}

TEST(ModelDifference, MarksOfThreeSubjectsHaveAJackknifeError) {
  Evaluation here = first, there = first;
  here.subjects = there.subjects = {"r", "s", "t"};
  here = marked(here, {1, 1, 1});
  there = marked(there, {1, 2, 4});
  const auto& at =
      group(model_difference({"A", &here}, {"B", &there}), "Marks, points").measures[0].by_modes[0];
  EXPECT_DOUBLE_EQ(at.difference.mean, 4.0 / 3);
  // Without r: 2; without s: 1.5; without t: 0.5.
  const double m = 4.0 / 3;
  EXPECT_NEAR(at.difference.standard_error,
              std::sqrt(2.0 / 3 * (std::pow(2 - m, 2) + std::pow(1.5 - m, 2) + std::pow(0.5 - m, 2))), 1e-14);
  EXPECT_EQ(at.p_value, 0.25);
}

TEST(ModelDifference, IsNotPairedForOtherShapesOrAnotherScale) {
  Evaluation other = second;
  other.names[1] = "z";
  const ModelDifference renamed = model_difference({"A", &first}, {"B", &other});
  EXPECT_EQ(renamed.why_not_paired, "A has no shape z, which B has");
  ASSERT_EQ(renamed.groups.size(), 1u);
  EXPECT_EQ(renamed.groups[0].name, "Specificity");
  Evaluation fewer = evaluation({{"a", "s", 1, 1}, {"b", "s", 1, 1}}, {1, 1});
  EXPECT_EQ(model_difference({"A", &first}, {"B", &fewer}).why_not_paired, "B has no shape c, which A has");
  Evaluation scaled = second;
  scaled.options.scale = ScaleMode::remove;
  EXPECT_THAT(model_difference({"A", &first}, {"B", &scaled}).why_not_paired, HasSubstr("size"));
}

TEST(CompareModels, ShowsDifferencesOfWhatIsPaired) {
  const testing::TemporaryFolder folder;
  const auto write = [&](const std::string& name, CorrespondingCohort cohort, double noise_mm) {
    Rng rng(7);
    for (auto& shape : cohort.corresponding)
      for (Vec3& p : shape) p += noise_mm * Vec3(rng.normal(), rng.normal(), rng.normal());
    std::filesystem::create_directories(folder.file(name));
    const EvaluationOptions quick{.draws = 5, .samples = 200, .specificity_samples = 50};
    write_metrics(folder.file(name), evaluate(cohort, quick, RunContext(2)));
  };
  CorrespondingCohort cohort = testing::torus_cohort({.shapes = 4});
  write("one/model", cohort, 0);
  write("two/model", cohort, 1);
  cohort.names[0] = "stranger";
  write("three", cohort, 0);

  const std::string one = folder.file("one/model").string(), two = folder.file("two/model").string();
  const ModelComparison compared = compare_models({one, two});
  EXPECT_THAT(compared.text, HasSubstr(two + " minus " + one + ": Generalization (leave one out)"))
      << "both folders are named model";
  EXPECT_THAT(compared.text, HasSubstr("all sign flips of 4 shapes"));
  EXPECT_THAT(compared.text, HasSubstr("Specificity beside"));
  EXPECT_THAT(compared.html, HasSubstr("two-sample standard error"));
  const auto difference = nlohmann::json::parse(compared.json).at("differences").at(0);
  EXPECT_EQ(difference.at("paired"), true);
  const auto measures = difference.at("second_minus_first");
  const auto worse = std::find_if(measures.begin(), measures.end(), [](const auto& measure) {
    return measure.at("measure") == "Representation, mean";
  });
  ASSERT_NE(worse, measures.end());
  EXPECT_GT(worse->at("mean_mm"), 0.2) << "noise of 1 mm";
  EXPECT_EQ(worse->at("p_value"), 0.125) << "2 of 16: worse for every shape";

  const ModelComparison strangers = compare_models({one, folder.file("three")});
  EXPECT_THAT(strangers.text, HasSubstr("three and model are not paired: model has no shape stranger"));
  EXPECT_THAT(strangers.text, Not(HasSubstr("minus model: Generalization")));
  EXPECT_THAT(strangers.text, HasSubstr("three minus model: Specificity"));
}

}  // namespace
}  // namespace foramen
