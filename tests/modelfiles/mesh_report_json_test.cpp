#include "modelfiles/mesh_report_json.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/meshes.hpp"

namespace foramen {
namespace {

TEST(MeshReportJson, OfAUsableSurfaceHasItsFiguresAndNoFinding) {
  const MeshReport report = inspect_mesh(testing::torus_soup(12, 9));
  const auto json = mesh_report_json(report);
  EXPECT_EQ(json.at("usable"), true);
  EXPECT_EQ(json.at("vertices"), 108);
  EXPECT_EQ(json.at("triangles"), 216);
  EXPECT_EQ(json.at("edges"), 324);
  EXPECT_EQ(json.at("euler_number"), 0);
  EXPECT_EQ(json.at("genus"), 1);
  EXPECT_EQ(json.at("area"), report.area);
  EXPECT_EQ(json.at("volume"), report.volume);
  EXPECT_EQ(json.at("likely_units"), "mm");
  EXPECT_TRUE(is_in_millimetres(report));
  EXPECT_FALSE(json.contains("finding"));
}

TEST(MeshReportJson, OfAnOpenSurfaceHasNoGenusAndSaysWhatToDo) {
  TriangleSoup open = testing::torus_soup(12, 9);
  open.triangles.pop_back();
  const auto json = mesh_report_json(inspect_mesh(open));
  EXPECT_EQ(json.at("usable"), false);
  EXPECT_EQ(json.at("closed"), false);
  EXPECT_EQ(json.at("boundary_edges"), 3);
  EXPECT_TRUE(json.at("genus").is_null());
  EXPECT_FALSE(json.at("finding").get<std::string>().empty());
  EXPECT_FALSE(json.at("remedy").get<std::string>().empty());
}

TEST(MeshReportJson, LikelyUnitsFollowTheSize) {
  const auto scaled = [](double factor) {
    TriangleSoup soup = testing::torus_soup(12, 9);
    for (Vec3& p : soup.points) p *= factor;
    return inspect_mesh(soup);
  };
  EXPECT_EQ(mesh_report_json(scaled(0.001)).at("likely_units"), "m");
  EXPECT_FALSE(is_in_millimetres(scaled(0.001)));
  EXPECT_TRUE(mesh_report_json(scaled(1e9)).at("likely_units").is_null());
}

}  // namespace
}  // namespace foramen
