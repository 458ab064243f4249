#include "foramen/evaluate/mark_transfer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foramen/core/error.hpp"
#include "support/messages.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

constexpr int around = 20, tube = 8;

/// Copies of one torus in different poses: each landmark corresponds exactly.
struct Copies {
  explicit Copies(int shapes) {
    const TriangleSoup torus = testing::torus_soup(around, tube, 30, 10);
    mesh = build_mesh(torus);
    cohort.triangles = torus.triangles;
    Rng rng(7);
    for (int s = 0; s < shapes; ++s) {
      poses.push_back(testing::random_pose(rng));
      cohort.names.push_back("shape" + std::to_string(s));
      cohort.corresponding.push_back(transformed(torus.points, poses.back()));
      cohort.inputs.push_back(transformed(mesh, poses.back()));
    }
    marks.resize(shapes);
  }
  void add(int shape, Mark mark) {
    for (Vec3& p : mark.points) p = poses[shape] * p;
    marks[shape].push_back(std::move(mark));
  }
  MarkTransfer transfer() const { return mark_transfer(cohort, marks, RunContext(2)); }
  Message refusal() const {
    return testing::refusal([&] { transfer(); });
  }

  Mesh mesh;
  CorrespondingCohort cohort;
  std::vector<RigidTransform> poses;
  std::vector<MarksOfShape> marks;
};

Vec3 vertex(const Copies& copies, int i, int j) { return copies.mesh.position(VertexId(i * tube + j)); }

/// A vertex of the outer side, raised over the surface.
Mark raised_point(const Copies& copies, const std::string& name, double height_mm) {
  return {name,
          MarkKind::point,
          {vertex(copies, 3, 0) + height_mm * vertex_normals(copies.mesh)[VertexId(3 * tube)]}};
}

/// The first `count` vertices of a ring around the tube, moved out of its plane.
Mark ring(const Copies& copies, MarkKind kind, int count, double shift_mm) {
  const double u = 2 * std::numbers::pi * 5 / around;
  Mark mark{"ring", kind, {}};
  for (int j = 0; j < count; ++j)
    mark.points.push_back(vertex(copies, 5, j) + shift_mm * Vec3(-std::sin(u), std::cos(u), 0));
  return mark;
}

const MarkPair& pair_of(const MarkTransfer& transfer, int from, int to) {
  return *std::find_if(transfer.pairs.begin(), transfer.pairs.end(),
                       [&](const MarkPair& p) { return p.from == from && p.to == to; });
}

TEST(MarkTransfer, MarksOfExactCopiesHaveNoError) {
  Copies copies(3);
  for (int s = 0; s < 3; ++s) {
    copies.add(s, raised_point(copies, "tip", 0));
    copies.add(
        s,
        {"open", MarkKind::open_curve, {vertex(copies, 0, 0), vertex(copies, 0, 1), vertex(copies, 0, 2)}});
    copies.add(s, ring(copies, MarkKind::closed_curve, tube, 0));
  }
  const MarkTransfer t = copies.transfer();
  ASSERT_TRUE(t.points && t.curves);
  EXPECT_LT(t.points->error.mean, 1e-12);
  EXPECT_LT(t.curves->error.mean, 0.02);  // the carried points cut the corners of the ring
  EXPECT_EQ(t.points->errors, 6 * 5);
  EXPECT_EQ(t.curves->errors, 6 * 2);
  ASSERT_EQ(t.by_point.size(), 5u);
  EXPECT_EQ(t.by_point[0].mark, "tip");
  EXPECT_EQ(t.by_point[2].part, MarkPart::middle);
  EXPECT_EQ(t.by_point[4].part, MarkPart::centroid);
  EXPECT_EQ(t.by_curve[1].mark, "ring");
  EXPECT_TRUE(t.reversed.empty());
  EXPECT_EQ(t.marked_shapes, 3);
  EXPECT_EQ(t.incomplete_shapes, 0);
}

TEST(MarkTransfer, ErrorOfAPointIsItsDistanceToTheCarriedOne) {
  // A point is carried from the surface below it, so that a pair's error is the height on the second shape.
  Copies copies(4);
  const double heights[] = {0.1, 0.2, 0.4, 0.8};
  for (int s = 0; s < 4; ++s) copies.add(s, raised_point(copies, "tip", heights[s]));
  copies.cohort.subjects = {"a", "a", "b", "c"};
  const MarkTransfer t = copies.transfer();
  EXPECT_FALSE(t.curves);
  ASSERT_EQ(t.pairs.size(), 10u);
  for (const MarkPair& pair : t.pairs) {
    EXPECT_NE(copies.cohort.subjects[pair.from], copies.cohort.subjects[pair.to]);
    EXPECT_NEAR(*pair.points, heights[pair.to], 1e-12);
    EXPECT_FALSE(pair.curves);
  }
  EXPECT_NEAR(t.points->error.mean, (2 * 0.1 + 2 * 0.2 + 3 * 0.4 + 3 * 0.8) / 10, 1e-12);
  EXPECT_NEAR(t.points->p95, 0.8, 1e-12);
  // Without a: 0.6. Without b: (0.1 + 0.2 + 2 * 0.8) / 4. Without c: (0.1 + 0.2 + 2 * 0.4) / 4.
  const double m = (0.6 + 0.475 + 0.275) / 3;
  ASSERT_TRUE(t.points->error.standard_error);
  EXPECT_NEAR(*t.points->error.standard_error,
              std::sqrt(2.0 / 3 * (std::pow(0.6 - m, 2) + std::pow(0.475 - m, 2) + std::pow(0.275 - m, 2))),
              1e-12);
  for (int s = 0; s < 4; ++s) EXPECT_NEAR(t.off_surface_mm[s], heights[s], 1e-12);
}

TEST(MarkTransfer, ACurveMovedOutOfItsPlaneHasThatError) {
  for (const MarkKind kind : {MarkKind::open_curve, MarkKind::closed_curve}) {
    Copies copies(3);
    const int count = kind == MarkKind::open_curve ? 5 : tube;
    for (int s = 0; s < 3; ++s) copies.add(s, ring(copies, kind, count, s == 2 ? 0.7 : 0));
    const MarkTransfer t = copies.transfer();
    EXPECT_NEAR(*pair_of(t, 0, 2).curves, 0.7, 1e-3);  // the carried points cut the corners of the ring
    EXPECT_LT(*pair_of(t, 0, 1).curves, 0.02);
    EXPECT_NEAR(*pair_of(t, 0, 2).points, 0.7, 1e-3);
  }
}

TEST(MarkTransfer, ASlippedCorrespondenceIsSeenAlongACurveInItsEndsAlone) {
  // Shape 1's landmarks are one step along the tube ahead, so that its ring is carried onto itself.
  Copies copies(3);
  for (int s = 0; s < 3; ++s) {
    copies.add(s, ring(copies, MarkKind::closed_curve, tube, 0));
    copies.add(s, {"start", MarkKind::point, {vertex(copies, 5, 0)}});
  }
  std::vector<Vec3>& points = copies.cohort.corresponding[1];
  for (int i = 0; i < around; ++i)
    std::rotate(points.begin() + i * tube, points.begin() + i * tube + 1, points.begin() + (i + 1) * tube);
  const MarkTransfer t = copies.transfer();
  EXPECT_LT(*pair_of(t, 0, 1).curves, 0.02);
  const auto tip = std::find_if(t.by_point.begin(), t.by_point.end(),
                                [](const PointTransfer& p) { return p.mark == "start"; });
  const double step = (vertex(copies, 5, 0) - vertex(copies, 5, 1)).norm();
  EXPECT_NEAR(tip->error.mean, 4 * step / 6, 1e-11);  // two of the six pairs lack shape 1
}

TEST(MarkTransfer, ACurveMarkedFromItsOtherEndIsNamed) {
  Copies copies(3);
  for (int s = 0; s < 3; ++s) {
    Mark mark = ring(copies, MarkKind::open_curve, 5, 0);
    if (s == 1) std::reverse(mark.points.begin(), mark.points.end());
    copies.add(s, mark);
  }
  const MarkTransfer t = copies.transfer();
  ASSERT_EQ(t.reversed.size(), 1u);
  EXPECT_EQ(t.reversed[0].shape, 1);
  EXPECT_EQ(t.reversed[0].mark, "ring");
  EXPECT_LT(t.curves->error.mean, 0.02);
  EXPECT_GT(t.by_point[0].error.mean, 5);
}

TEST(MarkTransfer, AMarkIsComparedWhereBothShapesHaveIt) {
  Copies copies(4);
  for (int s = 0; s < 3; ++s) copies.add(s, raised_point(copies, "tip", 0));
  copies.add(1, raised_point(copies, "rare", 0));
  copies.add(2, raised_point(copies, "rare", 0.5));
  const MarkTransfer t = copies.transfer();
  EXPECT_EQ(t.marked_shapes, 3);
  EXPECT_EQ(t.incomplete_shapes, 1);
  EXPECT_EQ(t.by_point[0].error.pairs, 6);
  EXPECT_EQ(t.by_point[1].error.pairs, 2);
  EXPECT_EQ(t.points->errors, 8);
  EXPECT_NEAR(*pair_of(t, 1, 2).points, 0.25, 1e-12);
  EXPECT_NEAR(t.points->error.mean, 0.25 / 6, 1e-12);  // each pair counts once, however many marks it has
}

TEST(MarkTransfer, MarksAreOnTheSurfaceBelowWherePeoplePutThem) {
  Copies copies(3);
  for (int s = 0; s < 3; ++s) {
    copies.add(s, raised_point(copies, "tip", 0.2 * s));
    if (s > 0) copies.add(s, ring(copies, MarkKind::open_curve, 5, 0));
  }
  const MarkTransfer t = copies.transfer();
  ASSERT_EQ(t.placed.size(), 5u);
  for (int s = 0; s < 3; ++s) {
    EXPECT_EQ(t.placed[s].mark, "tip");
    EXPECT_EQ(t.placed[s].shape, s);
    ASSERT_EQ(t.placed[s].places.size(), 1u);
    EXPECT_LT((position(copies.mesh, t.placed[s].places[0]) - vertex(copies, 3, 0)).norm(), 1e-12);
  }
  const PlacedMark& curve = t.placed[4];
  EXPECT_EQ(curve.mark, "ring");
  EXPECT_EQ(curve.kind, MarkKind::open_curve);
  EXPECT_EQ(curve.shape, 2);
  ASSERT_EQ(curve.places.size(), 20u);
  // Of the four equal sides of the marked curve.
  for (int i = 0; i < 20; ++i) {
    const double along = 4 * i / 19.0;
    const int side = std::min(3, static_cast<int>(along));
    const Vec3 there =
        (1 - (along - side)) * vertex(copies, 5, side) + (along - side) * vertex(copies, 5, side + 1);
    EXPECT_LT((position(copies.mesh, curve.places[i]) - there).norm(), 1e-9) << i;
  }
}

TEST(MarkTransfer, CurvesOfOneMarkArePlacedFromOneStartInOneDirection) {
  for (const MarkKind kind : {MarkKind::open_curve, MarkKind::closed_curve}) {
    const bool closed = kind == MarkKind::closed_curve;
    Copies copies(3);
    for (int s = 0; s < 3; ++s) {
      Mark mark = ring(copies, kind, closed ? tube : 5, 0);
      if (s == 1) std::reverse(mark.points.begin() + (closed ? 1 : 0), mark.points.end());
      if (s == 2 && closed) std::rotate(mark.points.begin(), mark.points.begin() + 2, mark.points.end());
      copies.add(s, mark);
    }
    const MarkTransfer t = copies.transfer();
    ASSERT_EQ(t.placed.size(), 3u);
    for (int s = 1; s < 3; ++s)
      for (std::size_t i = 0; i < 20; ++i)
        EXPECT_LT(
            (position(copies.mesh, t.placed[s].places[i]) - position(copies.mesh, t.placed[0].places[i]))
                .norm(),
            1e-9);
  }
}

TEST(MarkTransfer, MarksThatCannotBeComparedAreRefused) {
  {
    Copies copies(3);
    copies.add(0, {"tip", MarkKind::point, {Vec3::Zero(), Vec3::Ones()}});
    EXPECT_THAT(copies.refusal(), testing::says("'tip' of shape0 has 2 points"));
  }
  {
    Copies copies(3);
    copies.add(1, {"rim", MarkKind::closed_curve, {Vec3::Zero(), Vec3::Ones()}});
    EXPECT_THAT(copies.refusal(), testing::says("needs 3 or more"));
  }
  {
    Copies copies(3);
    copies.add(0, raised_point(copies, "tip", 0));
    copies.add(2, ring(copies, MarkKind::open_curve, 3, 0));
    copies.marks[2].back().name = "tip";
    EXPECT_THAT(copies.refusal(), testing::says("the mark 'tip' of shape2 is of the kind 'open'"));
  }
  {
    Copies copies(3);
    for (int k = 0; k < 2; ++k) copies.add(0, raised_point(copies, "tip", 0));
    EXPECT_THAT(copies.refusal(), testing::says("occurs twice"));
  }
  {
    Copies copies(3);
    copies.add(0, raised_point(copies, "tip", 0));
    copies.add(1, raised_point(copies, "tip", 0));
    copies.cohort.subjects = {"a", "a", "b"};
    EXPECT_THAT(copies.refusal(), testing::says("no two shapes of different subjects"));
  }
}

}  // namespace
}  // namespace foramen
