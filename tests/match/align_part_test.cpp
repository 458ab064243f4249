#include "foramen/match/align_part.hpp"

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "support/lopsided_torus.hpp"

namespace foramen {
namespace {

RigidTransform pose(double angle) {
  RigidTransform result = RigidTransform::Identity();
  result.rotate(Eigen::AngleAxisd(angle, Vec3(2, 1, -1).normalized())).pretranslate(Vec3(-60, 20, 130));
  return result;
}

// The open part of a surface in which x is below a limit.
Mesh side(const TriangleSoup& soup, double limit) {
  TriangleSoup part;
  std::vector<int> index(soup.points.size(), -1);
  for (const auto& t : soup.triangles) {
    std::array<int, 3> corners{};
    bool inside = true;
    for (const int v : t) inside = inside && soup.points[v].x() < limit;
    if (!inside) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      int& at = index[t[k]];
      if (at < 0) {
        at = static_cast<int>(part.points.size());
        part.points.push_back(soup.points[t[k]]);
      }
      corners[k] = at;
    }
    part.triangles.push_back(corners);
  }
  return build_mesh(std::move(part));
}

TEST(AlignPart, FindsTheWayBackFromAnyPose) {
  const TriangleSoup soup = testing::knobbly_torus_soup(90, 45);
  const Mesh whole = build_mesh(soup);
  for (const double limit : {1000.0, 10.0, -5.0}) {
    const Mesh part = limit > 100 ? whole : side(soup, limit);
    for (const double angle : {0.3, 1.6, 3.0}) {
      const Mesh moved = transformed(part, pose(angle));
      const Alignment best = align_part(moved, whole, RunContext(2)).front();
      double largest = 0;
      for (VertexId v : part.vertices())
        largest = std::max(largest, (best.transform * moved.position(v) - part.position(v)).norm());
      EXPECT_LT(largest, 0.5) << "limit " << limit << ", angle " << angle;
      EXPECT_LT(best.residual, best.second_best);
    }
  }
}

TEST(AlignPart, AnswersAreSortedAndDiffer) {
  const TriangleSoup soup = testing::torus_soup(60, 30);  // every rotation about its axis fits equally well
  const std::vector<Alignment> all = align_part(side(soup, 0), build_mesh(soup), RunContext(1));
  ASSERT_EQ(all.size(), 4u);
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_GE(all[i].residual, all[i - 1].residual);
    EXPECT_EQ(all[i - 1].second_best, all[i].residual);
    const double angle =
        Eigen::AngleAxisd(all[i].transform.linear() * all[0].transform.linear().transpose()).angle();
    EXPECT_GT(angle, 0.2);
  }
}

TEST(AlignPart, ThreadsChangeNothing) {
  const TriangleSoup soup = testing::lopsided_torus_soup(40, 20);
  const Mesh part = transformed(side(soup, 5), pose(1)), whole = build_mesh(soup);
  EXPECT_EQ(align_part(part, whole, RunContext(1)).front().transform.matrix(),
            align_part(part, whole, RunContext(2)).front().transform.matrix());
}

TEST(AlignPart, RefusesWhatIsOutOfRange) {
  const Mesh mesh = build_mesh(testing::torus_soup(12, 9));
  EXPECT_THROW(align_part(mesh, mesh, RunContext(), {.normal_weight = -1}), InvalidInput);
  EXPECT_THROW(align_part(mesh, mesh, RunContext(), {.rotations = 0}), InvalidInput);
  EXPECT_THROW(align_part(mesh, mesh, RunContext(), {.tolerance = -1}), InvalidInput);
}

}  // namespace
}  // namespace foramen
