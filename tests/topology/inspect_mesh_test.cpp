#include "foramen/topology/inspect_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <numbers>

#include "foramen/core/error.hpp"
#include "support/double_torus.hpp"
#include "support/meshes.hpp"
#include "support/real_meshes.hpp"

namespace foramen {
namespace {

using testing::genus2_soup;
using ::testing::HasSubstr;
using testing::torus_soup;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TriangleSoup tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

TriangleSoup joined(TriangleSoup a, const TriangleSoup& b, const Vec3& shift) {
  const int offset = static_cast<int>(a.points.size());
  for (const Vec3& p : b.points) a.points.emplace_back(p + shift);
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return a;
}

TEST(InspectMesh, TorusByFormula) {
  const MeshReport r = inspect_mesh(torus_soup(40, 20));
  EXPECT_EQ(r.vertices, 800);
  EXPECT_EQ(r.triangles, 1600);
  EXPECT_EQ(r.edges, 2400);
  EXPECT_EQ(r.components, 1);
  EXPECT_EQ(r.euler_number, 0);
  EXPECT_EQ(r.genus, 1);
  EXPECT_TRUE(r.closed() && r.manifold() && r.oriented());
  EXPECT_FALSE(r.inward);
  EXPECT_EQ(r.unused_vertices + r.invalid_triangles + r.non_finite_vertices + r.degenerate_triangles +
                r.duplicate_triangles + r.duplicate_vertices,
            0);
  const double pi = std::numbers::pi;
  EXPECT_NEAR(r.area / (4 * pi * pi * 20 * 8), 1, 0.02);
  EXPECT_NEAR(r.volume / (2 * pi * pi * 20 * 8 * 8), 1, 0.03);
  EXPECT_NEAR((r.box.high - Vec3(28, 28, 8)).norm(), 0, 1e-12);
  EXPECT_FALSE(obstacle_to_model(r).has_value());
}

TEST(InspectMesh, EulerNumberAndGenusOfKnownSurfaces) {
  EXPECT_EQ(inspect_mesh(tetrahedron()).genus, 0);
  EXPECT_EQ(inspect_mesh(genus2_soup(12, 8)).genus, 2);
  EXPECT_EQ(inspect_mesh(genus2_soup(12, 8)).euler_number, -2);
  EXPECT_NEAR(inspect_mesh(tetrahedron()).volume, 1, 1e-14);
}

TEST(InspectMesh, VolumeFarFromTheOriginAndInward) {
  TriangleSoup soup = tetrahedron();
  for (Vec3& p : soup.points) p += Vec3(1e6, -1e6, 1e6);
  EXPECT_NEAR(inspect_mesh(soup).volume, 1, 1e-8);
  for (auto& t : soup.triangles) std::swap(t[0], t[1]);
  const MeshReport r = inspect_mesh(soup);
  EXPECT_NEAR(r.volume, -1, 1e-8);
  EXPECT_TRUE(r.inward);
  TriangleSoup torus = torus_soup(9, 7);
  for (auto& t : torus.triangles) std::swap(t[0], t[1]);
  EXPECT_FALSE(obstacle_to_model(inspect_mesh(torus)).has_value()) << "inward winding is no obstacle";
}

TEST(InspectMesh, RenumberingChangesNothing) {
  for (const TriangleSoup& soup : {testing::bumpy_torus_soup(13, 9, 3), genus2_soup(9, 7)}) {
    const MeshReport a = inspect_mesh(soup), b = inspect_mesh(testing::renumbered(soup, 8));
    EXPECT_EQ(a.edges, b.edges);
    EXPECT_EQ(a.genus, b.genus);
    EXPECT_NEAR(a.area, b.area, 1e-9 * a.area);
    EXPECT_NEAR(a.mean_edge, b.mean_edge, 1e-12 * a.mean_edge);
    EXPECT_EQ(a.box.low, b.box.low);
  }
}

// A surface with one defect, the count that must change, and the obstacle that must be named.
struct Broken {
  std::string name;
  TriangleSoup soup;
  int MeshReport::*count;
  int expected;
  std::string finding, advice;
};

void PrintTo(const Broken& b, std::ostream* out) { *out << b.name; }

std::vector<Broken> broken_surfaces() {
  std::vector<Broken> all;
  const auto add = [&](const std::string& name, TriangleSoup soup, int MeshReport::*count, int expected,
                       const std::string& finding, const std::string& advice) {
    all.push_back({name, std::move(soup), count, expected, finding, advice});
  };
  const TriangleSoup torus = torus_soup(10, 8);
  TriangleSoup s = torus;
  s.triangles.pop_back();
  add("one_hole", s, &MeshReport::boundary_edges, 3, "it is open: 3 boundary edges", "fills small holes");
  s = torus;
  std::swap(s.triangles[5][0], s.triangles[5][1]);
  add("one_flipped", s, &MeshReport::misoriented_edges, 3, "not all wound the same way (3 edges",
      "winds them alike");
  s = torus;
  s.points.emplace_back(0, 0, 0);
  s.triangles.push_back({s.triangles[0][0], s.triangles[0][1], 80});
  add("fin", s, &MeshReport::non_manifold_edges, 1, "1 edge belongs to more than two triangles",
      "inner walls");
  s = torus;
  s.triangles.push_back(s.triangles[7]);
  add("duplicate", s, &MeshReport::duplicate_triangles, 1, "1 triangle is there twice", "repair the surface");
  s = joined(torus, torus, Vec3(100, 0, 0));
  add("two_pieces", s, &MeshReport::components, 2, "it consists of 2 separate pieces",
      "keeps the largest piece");
  s = joined(torus, torus, Vec3(100, 0, 0));
  for (auto& t : s.triangles)
    for (int& corner : t)
      if (corner == 80) corner = 0;
  add("pinched", s, &MeshReport::non_manifold_vertices, 1, "1 vertex joins parts", "parts them");
  s = torus;
  s.points[3].y() = nan;
  add("nan", s, &MeshReport::non_finite_vertices, 1, "1 vertex has a coordinate that is not a finite",
      "delete them");
  s = torus;
  s.triangles[4][1] = 80;
  add("out_of_range", s, &MeshReport::invalid_triangles, 1, "1 triangle uses a vertex that does not exist",
      "invalid faces");
  s = torus;
  s.triangles[4][1] = s.triangles[4][0];
  add("repeated_corner", s, &MeshReport::degenerate_triangles, 1, "one vertex twice", "invalid faces");
  add("sphere", tetrahedron(), &MeshReport::euler_number, 2, "(genus 0)", "canal");
  add("two_handles", genus2_soup(9, 7), &MeshReport::euler_number, -2, "genus 2: 2 holes",
      "foramina transversaria");
  add("empty", {}, &MeshReport::triangles, 0, "it has no triangles", "export the surface");
  add("points_only", {torus.points, {}}, &MeshReport::unused_vertices, 80, "it has no triangles",
      "export the surface");
  return all;
}

class BrokenSurface : public ::testing::TestWithParam<Broken> {};

TEST_P(BrokenSurface, IsCountedAndExplained) {
  const Broken& b = GetParam();
  const MeshReport report = inspect_mesh(b.soup);
  EXPECT_EQ(report.*(b.count), b.expected);
  const auto obstacle = obstacle_to_model(report);
  ASSERT_TRUE(obstacle.has_value());
  EXPECT_THAT(obstacle->finding, HasSubstr(b.finding));
  EXPECT_THAT(obstacle->advice, HasSubstr(b.advice));
  const bool can_be_repaired = obstacle->advice.find("repair the surface") != std::string::npos;
  EXPECT_EQ(obstacle->remedies,
            can_be_repaired ? std::vector<Remedy>{{RemedyKind::repair}} : std::vector<Remedy>());
  EXPECT_EQ(report.genus.has_value(),
            b.name == "sphere" || b.name == "two_handles" || b.name == "nan" || b.name == "unused");
}

const auto case_name = [](const auto& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(Each, BrokenSurface, ::testing::ValuesIn(broken_surfaces()), case_name);

TEST(InspectMesh, DegenerateTrianglesAndDoubleVerticesAreNoObstacle) {
  TriangleSoup soup = torus_soup(10, 8);
  soup.points[9] = soup.points[10];  // two triangles collapse, the surface stays closed
  const MeshReport r = inspect_mesh(soup);
  EXPECT_EQ(r.duplicate_vertices, 1);
  EXPECT_EQ(r.degenerate_triangles, 2);
  EXPECT_FALSE(obstacle_to_model(r).has_value());
  soup.points.emplace_back(-0.0, 0, 0);
  soup.points.emplace_back(0, -0.0, 0);
  EXPECT_EQ(inspect_mesh(soup).duplicate_vertices, 2) << "0 and -0 are the same place";
}

TEST(InspectMesh, AStrayVertexDoesNotStretchTheBox) {
  TriangleSoup soup = torus_soup(10, 8);
  soup.points.emplace_back(1e9, 0, 0);
  const MeshReport r = inspect_mesh(soup);
  EXPECT_NEAR(r.box.high.x(), 28, 1e-12);
  EXPECT_EQ(r.degenerate_triangles, 0);
}

// There is no obstacle if and only if the mesh can be built and is one closed surface of genus 1.
TEST(InspectMesh, AgreesWithBuildMeshOnAnySoup) {
  const double values[] = {nan, std::numeric_limits<double>::infinity(), 1e308, -1e308, 0, 1e-308};
  Rng rng(17);
  int usable = 0, refused = 0;
  for (int round = 0; round < 3000; ++round) {
    TriangleSoup soup = round % 3 == 0   ? torus_soup(3 + rng.below(3), 3 + rng.below(3))
                        : round % 3 == 1 ? tetrahedron()
                                         : genus2_soup(4, 4);
    for (int change = rng.below(3); change > 0; --change) {
      auto& triangle = soup.triangles[rng.below(static_cast<int>(soup.triangles.size()))];
      const int kind = rng.below(6);
      if (kind == 0) triangle[rng.below(3)] = rng.below(40) - 4;
      if (kind == 1) triangle = {rng.below(5), rng.below(5), rng.below(5)};
      if (kind == 2) std::swap(triangle[0], triangle[1]);
      if (kind == 3) soup.triangles.push_back(triangle);
      if (kind == 4) soup.points[rng.below(4)][rng.below(3)] = values[rng.below(6)];
      if (kind == 5) std::swap(triangle, soup.triangles.back());
    }
    if (rng.below(8) == 0) soup.triangles.resize(rng.below(static_cast<int>(soup.triangles.size())));
    const MeshReport report = inspect_mesh(soup);
    bool builds = true, torus = false;
    try {
      const Mesh mesh = build_mesh(soup);
      torus = mesh.face_count() > 0 && mesh.is_closed() && mesh.euler_characteristic() == 0 &&
              report.components == 1;
    } catch (const InvalidInput&) {
      builds = false;
    }
    EXPECT_EQ(!obstacle_to_model(report).has_value(), torus) << round;
    if (report.genus && report.unused_vertices == 0 && report.non_finite_vertices == 0 &&
        report.invalid_triangles == 0) {
      EXPECT_TRUE(builds) << round;
    }
    torus ? ++usable : ++refused;
  }
  EXPECT_GT(usable, 300);
  EXPECT_GT(refused, 300);
}

TEST(InspectMesh, RealDataHaveTheGenusInTheirName) {
  FORAMEN_NEEDS_REAL_DATA();
  int files = 0;
  for (const char* folder : {"lumbar", "thoracic", "cervical", "defective"})
    for (const auto& entry : std::filesystem::directory_iterator(testing::data_dir() / folder)) {
      const std::string name = entry.path().stem().string();
      SCOPED_TRACE(name);
      const auto tag = name.find("genus");
      const int genus = tag == std::string::npos ? 1 : std::stoi(name.substr(tag + 5));
      const MeshReport report = inspect_mesh(testing::read_real_mesh(entry.path()).soup());
      EXPECT_EQ(report.genus, genus);
      EXPECT_FALSE(report.inward);
      EXPECT_EQ(obstacle_to_model(report).has_value(), genus != 1);
      if (genus > 1) {
        EXPECT_THAT(obstacle_to_model(report)->finding, HasSubstr("genus " + std::to_string(genus)));
      }
      ++files;
    }
  EXPECT_EQ(files, 22 + 45 + 20 + 5);
}

}  // namespace
}  // namespace foramen
