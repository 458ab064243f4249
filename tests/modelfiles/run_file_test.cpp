#include "modelfiles/run_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// Of three shapes: a label that was repaired, one without a map, one that was left out.
RunRecord recorded_run() {
  RunRecord run{.version = "1.2.3", .command = "foramen build shapes", .seed = 18446744073709551615u};
  run.options =
      RunOptions({{"method", "torus"}, {"objective", nullptr}, {"scale", "remove"}, {"list", {1, 2.5}}});
  ExtractionReport extraction;
  extraction.contact = EdgeContact::apart;
  extraction.cut_at = {"left"};
  extraction.deviation_mm.p95 = 0.25;
  run.inputs = {{"a.nii", "00", 10, 20, 21, "verse, assumed", extraction},
                {.file = "b.ply", .sha256 = "01", .vertices = 7}};
  run.reference = "a";
  run.template_motion_mm = {0.1, 0.2};
  run.landmarks = 4;
  run.landmarks_inserted = 3;
  run.landmark_triangles = 8;
  UsedShape mapped{.seconds = 0.5, .alignment_residual_mm = 1.0 / 3};
  mapped.repair.emplace().changes = {{"holes filled", {250, {Vec3(1, 2, 3)}}}};
  mapped.repair->canal = {LoopKind::tunnel, 60, 90, Vec3(4, 5, 6)};
  mapped.map = RunMap{.iterations = 5, .distortion = 4.25};
  mapped.map->certificate.homology << 0, 1, -1, 0;
  mapped.flips_in_map = 2;
  run.shapes = {{"a", ShapeStatus::reference, "repaired", mapped},
                {"b", ShapeStatus::used, "", UsedShape{.without_compatible_point = 9}},
                {"c", ShapeStatus::left_out, "no mesh"}};
  run.seconds_by_stage = {{"register", 1.5}, {"evaluate", 2}};
  return run;
}

// What every version wrote.
constexpr const char* oldest = R"({"version": "0.1.0", "command": "foramen build shapes",
  "options": {"method": "icp", "objective": null, "scale": "keep", "gone": 3},
  "inputs": [{"file": "a.ply", "sha256": "00"}], "reference": "a", "landmarks_inserted": 0, "landmark_triangles": 8,
  "shapes": [{"name": "a", "status": "reference", "reason": "", "flips_in_map": 0},
             {"name": "c", "status": "left out", "reason": "no mesh"}]})";

std::string with(std::string text, const std::string& old_part, const std::string& new_part) {
  const auto at = text.find(old_part);
  if (at == std::string::npos) throw std::logic_error(old_part + " is not there");
  return text.replace(at, old_part.size(), new_part);
}

void expect_run_refused(const std::string& text, const std::string& place) {
  try {
    parse_run(text, "m/run.json");
    FAIL() << "not refused; expected: " << place;
  } catch (const IoError& e) {
    EXPECT_THAT(e.what(), StartsWith("m/run.json: " + place));
  }
}

TEST(RunFile, ComesBackAsItWasWritten) {
  const std::string text = run_json(recorded_run());
  const RunRecord run = parse_run(text, "run.json");
  EXPECT_EQ(run_json(run), text);
  EXPECT_EQ(run.seed, 18446744073709551615u);
  EXPECT_EQ(run.options.scale(), ScaleMode::remove);
  EXPECT_EQ(run.options.objective(), std::nullopt);
  ASSERT_EQ(run.inputs.size(), 2u);
  EXPECT_EQ(run.inputs[0].extraction->contact, EdgeContact::apart);
  EXPECT_EQ(run.inputs[0].names_from, "verse, assumed");
  EXPECT_EQ(run.inputs[0].extraction->deviation_mm.p95, 0.25);
  EXPECT_EQ(run.inputs[1].triangles, std::nullopt);
  ASSERT_EQ(run.shapes.size(), 3u);
  const UsedShape& mapped = run.shapes[0].used.value();
  EXPECT_EQ(mapped.alignment_residual_mm, 1.0 / 3);
  EXPECT_EQ(mapped.repair->changes[0].places.count, 250);
  EXPECT_EQ(mapped.repair->canal.position, Vec3(4, 5, 6));
  EXPECT_EQ(mapped.map->certificate.homology(1, 0), -1);
  EXPECT_EQ(run.shapes[1].used->map, std::nullopt);
  EXPECT_EQ(run.shapes[1].used->without_compatible_point, 9);
  EXPECT_EQ(run.shapes[2].used, std::nullopt);
}

TEST(RunFile, SaysWhatItDoesNotKnow) {
  const auto json = nlohmann::ordered_json::parse(run_json(recorded_run()));
  EXPECT_TRUE(json.at("shapes").at(1).at("flips_in_map").is_null());
  EXPECT_FALSE(json.at("shapes").at(1).contains("distortion"));
  EXPECT_FALSE(json.at("shapes").at(1).contains("repair"));
  EXPECT_EQ(json.at("shapes").at(2).size(), 3u) << "name, status, reason";
  EXPECT_FALSE(json.at("inputs").at(1).contains("label"));
}

TEST(RunFile, OfAnEarlierVersionIsRead) {
  const RunRecord run = parse_run(oldest, "run.json");
  EXPECT_EQ(run.options.method(), Method::icp);
  EXPECT_EQ(run.options.by_name().at("gone"), 3);
  EXPECT_EQ(run.self_intersections_before_mending, 0);
  EXPECT_EQ(run.shapes[0].used->flips_in_map, 0);
  EXPECT_EQ(run.shapes[0].used->map, std::nullopt);
  EXPECT_EQ(run.shapes[1].used, std::nullopt);
}

TEST(RunFile, ThatIsDamagedIsRefusedWithThePlace) {
  expect_run_refused("no json", "is not JSON");
  expect_run_refused(std::string(oldest).substr(0, 200), "is not JSON");
  expect_run_refused("[]", "the whole is no object");
  expect_run_refused("{}", "version is missing");
  expect_run_refused(with(oldest, "\"scale\"", "\"skale\""), "options.scale is missing");
  expect_run_refused(with(oldest, "\"icp\"", "\"icq\""), "options.method is \"icq\"");
  expect_run_refused(with(oldest, "\"left out\"", "\"lost\""), "shapes[1].status is \"lost\"");
  expect_run_refused(with(oldest, "\"no mesh\"", "3"), "shapes[1].reason is no text");
  expect_run_refused(with(oldest, "\"flips_in_map\": 0", "\"x\": 0"), "the shape a is part of the model");
  expect_run_refused(with(oldest, "\"flips_in_map\": 0", "\"flips_in_map\": 0.5"),
                     "shapes[0].flips_in_map is no whole number");
  expect_run_refused(with(oldest, "\"landmark_triangles\": 8", "\"landmark_triangles\": 3000000000"),
                     "landmark_triangles is no whole number in its range");
  expect_run_refused(with(oldest, "\"shapes\": [{", "\"shapes\": [7, {"), "shapes[0] is no object");
  expect_run_refused(with(oldest, "\"sha256\": \"00\"", "\"sha256\": \"00\", \"label\": \"L1\""),
                     "inputs[0].label is no whole number");
}

}  // namespace
}  // namespace foramen
