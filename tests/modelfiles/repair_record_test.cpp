#include "modelfiles/repair_record.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace foramen {
namespace {

TEST(RepairRecord, SaysWhatWasChangedAndWhere) {
  RepairReport report;
  report.changes.push_back({RepairKind::holes, {Vec3(1, 2, 3), Vec3(4, 5, 6)}});
  report.removed_handles.push_back({LoopKind::handle, 2.5, 11, Vec3(7, 8, 9)});
  report.canal = {LoopKind::tunnel, 60, 90, Vec3::Zero()};
  report.largest_move_mm = 0.25;
  const nlohmann::ordered_json json = repair_json(report);
  EXPECT_EQ(json.at("changes").at(0).at("count"), 2);
  EXPECT_EQ(json.at("changes").at(0).at("positions").at(1), (nlohmann::ordered_json{4, 5, 6}));
  EXPECT_EQ(json.at("removed_handles").at(0).at("kind"), "bridge");
  EXPECT_EQ(json.at("removed_handles").at(0).at("length_mm"), 2.5);
  EXPECT_EQ(json.at("canal").at("kind"), "tunnel");
  EXPECT_EQ(json.at("largest_move_mm"), 0.25);
  EXPECT_EQ(json.at("remaining_self_intersections").at("count"), 0);
}

TEST(RepairRecord, ALongListIsCountedButNotWrittenOut) {
  RepairReport report;
  report.changes.push_back({RepairKind::duplicate_vertices, std::vector<Vec3>(250, Vec3::Zero())});
  const nlohmann::ordered_json change = repair_json(report).at("changes").at(0);
  EXPECT_EQ(change.at("count"), 250);
  EXPECT_EQ(change.at("positions").size(), 100u);
}

}  // namespace
}  // namespace foramen
