#include "foramen/core/mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

using testing::torus_soup;

// Runs build_mesh(), which must throw this error, and returns its message.
template <class Expected>
std::string refusal(const TriangleSoup& soup) {
  try {
    build_mesh(soup);
  } catch (const Expected& e) {
    return e.what();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

TEST(Mesh, TorusIsClosedAndHasEulerNumberZero) {
  const Mesh mesh = build_mesh(torus_soup(8, 6));
  EXPECT_TRUE(mesh.is_closed());
  EXPECT_EQ(mesh.euler_characteristic(), 0);
  EXPECT_EQ(mesh.edge_count(), 3 * mesh.vertex_count());
}

TEST(Mesh, HalfedgesFitTogether) {
  const Mesh mesh = build_mesh(testing::renumbered(torus_soup(7, 5), 3));
  for (HalfedgeId h : mesh.halfedges()) {
    EXPECT_EQ(mesh.twin(mesh.twin(h)), h);
    EXPECT_EQ(mesh.from(mesh.twin(h)), mesh.to(h));
    EXPECT_EQ(mesh.edge(mesh.twin(h)), mesh.edge(h));
    EXPECT_EQ(Mesh::next(Mesh::next(Mesh::next(h))), h);
    EXPECT_EQ(mesh.find_halfedge(mesh.from(h), mesh.to(h)), h);
  }
}

TEST(Mesh, FanOfABoundaryVertexReachesAllItsTriangles) {
  TriangleSoup soup = torus_soup(8, 6);
  soup.triangles.erase(soup.triangles.begin() + 10);
  const Mesh mesh = build_mesh(soup);
  EXPECT_FALSE(mesh.is_closed());
  std::vector<int> degree(soup.points.size(), 0);
  for (const auto& t : soup.triangles)
    for (int v : t) ++degree[v];
  for (VertexId v : mesh.vertices()) EXPECT_EQ(static_cast<int>(mesh.fan(v).size()), degree[v.index]);
}

TEST(Mesh, RefusesWhatIsBroken) {
  const TriangleSoup good = torus_soup(8, 6);
  using ::testing::HasSubstr;
  auto bad = good;
  bad.triangles[3][1] = 9999;
  EXPECT_THAT(refusal<InvalidInput>(bad), HasSubstr("triangle 3 uses vertex 9999"));
  bad = good;
  bad.triangles[5][1] = bad.triangles[5][0];
  EXPECT_THAT(refusal<InvalidInput>(bad), HasSubstr("triangle 5 uses one vertex twice"));
  bad = good;
  bad.points[7].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal<InvalidInput>(bad), HasSubstr("vertex 7"));
  bad = good;
  std::swap(bad.triangles[4][1], bad.triangles[4][2]);
  EXPECT_THAT(refusal<TopologyError>(bad), HasSubstr("not oriented"));
  bad = good;
  bad.triangles.push_back({bad.triangles[0][0], bad.triangles[0][1], 40});
  EXPECT_THAT(refusal<TopologyError>(bad), HasSubstr("belongs to 3 triangles"));
  bad = good;
  bad.points.emplace_back(0, 0, 0);
  EXPECT_THAT(refusal<TopologyError>(bad), HasSubstr("belongs to no triangle"));
  bad = good;
  const int shift = static_cast<int>(good.points.size()) - 1;  // a second torus that shares vertex 0
  for (std::size_t v = 1; v < good.points.size(); ++v) bad.points.push_back(good.points[v] + Vec3(100, 0, 0));
  for (auto t : good.triangles) {
    for (int& v : t) v = v == 0 ? 0 : v + shift;
    bad.triangles.push_back(t);
  }
  EXPECT_THAT(refusal<TopologyError>(bad), HasSubstr("do not form one fan"));
}

}  // namespace
}  // namespace foramen
