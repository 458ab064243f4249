#include "correspond/register_group.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "correspond/register_shape.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "sampling/lift_to_surface.hpp"
#include "support/lopsided_torus.hpp"
#include "support/torus_cohort.hpp"
#include "topology/linking.hpp"

namespace foramen {
namespace {

using testing::knobbly_torus_soup;

// A knotted torus: a tube round a trefoil knot.
Mesh knotted_torus() {
  constexpr int along = 160, across = 12;
  const auto centre = [](double t) {
    return Vec3(12 * (std::sin(t) + 2 * std::sin(2 * t)), 12 * (std::cos(t) - 2 * std::cos(2 * t)),
                -12 * std::sin(3 * t));
  };
  TriangleSoup soup = testing::torus_soup(along, across);
  for (int i = 0; i < along; ++i) {
    const double t = 2 * std::numbers::pi * i / along;
    const Vec3 tangent = (centre(t + 1e-4) - centre(t - 1e-4)).normalized();
    const Vec3 side = tangent.cross(Vec3::UnitZ()).normalized(), up = side.cross(tangent);
    for (int j = 0; j < across; ++j) {
      const double angle = 2 * std::numbers::pi * j / across;
      soup.points[i * across + j] = centre(t) + 4 * (std::cos(angle) * side - std::sin(angle) * up);
    }
  }
  return build_mesh(std::move(soup));
}

// Vertices with the same index are corresponding points, because all triangulations of the same resolution
// have the same indices.
class RegisterGroup : public ::testing::Test {
 protected:
  static constexpr int around = 60, tube = 36, count = 4;
  static std::vector<Mesh> cohort() {
    std::vector<Mesh> shapes;
    for (int i = 0; i < count; ++i) {
      Rng rng = Rng(5).fork(static_cast<std::uint64_t>(i));
      const testing::SmoothDisplacement displace(0.7, 90, rng.fork(0));
      const RigidTransform pose = testing::random_pose(rng);
      TriangleSoup soup = knobbly_torus_soup(around, tube);
      for (Vec3& p : soup.points) p = pose * displace(p);
      shapes.push_back(build_mesh(std::move(soup)));
    }
    return shapes;
  }
  static RegisterGroupOptions small() {
    RegisterGroupOptions options;
    options.mean = {.vertices = 1500, .grid_points = 6000};
    options.round_limit = 2;
    options.still_mm = 0.02;  // small enough for two rounds
    return options;
  }
  // The mean, over all vertices v and ordered pairs (a, b) of shapes, of the distance on b between the point
  // that the maps assign to vertex v of a and vertex v of b.
  static double mean_error(const std::vector<Mesh>& shapes, const GroupRegistration& group) {
    double sum = 0;
    int pairs = 0;
    for (std::size_t b = 0; b < shapes.size(); ++b) {
      const TorusLocator locator(shapes[b], group.members[b].registered->shape_map.map);
      for (std::size_t a = 0; a < shapes.size(); ++a)
        for (VertexId v : shapes[a].vertices()) {
          if (a == b) continue;
          const Vec2& turns = group.members[a].registered->shape_map.map.turns[v];
          sum += (position(shapes[b], locator.locate(turns)) - shapes[b].position(v)).norm();
          ++pairs;
        }
    }
    return sum / pairs;
  }
  // The mean error of closest points after rigid alignment to the first shape.
  double mean_error_of_closest_points(const std::vector<Mesh>& shapes) const {
    double sum = 0;
    int points = 0;
    for (std::size_t b = 1; b < shapes.size(); ++b) {
      const Mesh aligned = transformed(shapes[b], align(shapes[b], shapes[0], ctx).transform);
      const TriangleTree tree(aligned);
      for (VertexId v : aligned.vertices()) {
        sum += (tree.closest(shapes[0].position(v)).point - aligned.position(v)).norm();
        ++points;
      }
    }
    return sum / points;
  }
  const RunContext ctx{2};
};

TEST_F(RegisterGroup, RecoversTheTrueCorrespondenceWithoutAFlip) {
  const std::vector<Mesh> shapes = cohort();
  const Reference reference = map_reference(shapes[0], ctx);
  const GroupRegistration group = register_group(shapes, reference, 0, ctx, small());
  for (const GroupMember& member : group.members) {
    ASSERT_TRUE(member.registered) << member.failure.text;
    EXPECT_TRUE(member.registered->shape_map.certificate.valid());
    EXPECT_TRUE(
        seifert_test(member.registered->homology, member.registered->seifert, reference.loops.seifert));
  }
  EXPECT_LT(mean_error(shapes, group), 0.3 * mean_error_of_closest_points(shapes));
}

TEST_F(RegisterGroup, AnotherReferenceLeadsToTheSameCorrespondence) {
  const std::vector<Mesh> shapes = cohort();
  // The mean distance on shape 1 between the points that correspond to the vertices of shape 0 with one
  // reference and with another.
  const auto difference = [&](const RegisterGroupOptions& options) {
    std::vector<std::vector<Vec3>> carried;
    for (int reference : {0, 2}) {
      const GroupRegistration group =
          register_group(shapes, map_reference(shapes[reference], ctx), reference, ctx, options);
      const TorusLocator locator(shapes[1], group.members[1].registered->shape_map.map);
      carried.push_back(lift_to_surface(locator, group.members[0].registered->shape_map.map.turns.values()));
    }
    double sum = 0;
    for (std::size_t v = 0; v < carried[0].size(); ++v) sum += (carried[0][v] - carried[1][v]).norm();
    return sum / static_cast<double>(carried[0].size());
  };
  RegisterGroupOptions without_mean = small();
  without_mean.round_limit = 0;
  const double with_mean = difference(small());
  EXPECT_LT(with_mean, 0.3);
  EXPECT_LT(with_mean, difference(without_mean));
}

// The shapes have one mode of variation, so the position of points on one shape follows from the other
// shapes.
TEST_F(RegisterGroup, ThePriorFromTheOtherShapesLowersTheError) {
  const testing::SmoothDisplacement mode(0.6, 90, Rng(22));
  std::vector<Mesh> shapes;
  for (int i = 0; i < 6; ++i) {
    Rng rng = Rng(9).fork(static_cast<std::uint64_t>(i));
    const RigidTransform pose = testing::random_pose(rng);
    TriangleSoup soup = knobbly_torus_soup(around, tube);
    for (Vec3& p : soup.points) p = pose * Vec3(p + (i - 2.5) / 2.5 * (mode(p) - p));
    shapes.push_back(build_mesh(std::move(soup)));
  }
  const Reference reference = map_reference(shapes[2], ctx);
  const auto error = [&](Bending bending) {
    RegisterGroupOptions options = small();
    options.bending = bending;
    const GroupRegistration group = register_group(shapes, reference, 2, ctx, options);
    EXPECT_EQ(group.unexplained_shares.size(), bending == Bending::cohort ? 2 : 0);
    return mean_error(shapes, group);
  };
  EXPECT_LT(error(Bending::cohort), 0.9 * error(Bending::smooth));
}

TEST_F(RegisterGroup, DistortionIsMeasuredWhereItIsAskedFor) {
  const std::vector<Mesh> shapes = cohort();
  const Reference reference = map_reference(shapes[0], ctx);
  RegisterGroupOptions options = small();
  options.round_limit = 0;
  const auto of_reference = [&] {
    return register_group({shapes[0]}, reference, 0, ctx, options)
        .members[0]
        .registered->shape_map.distortion;
  };
  EXPECT_LT(of_reference(), 4.1);
  options.distortion = DistortionMeasure::in_plane;
  EXPECT_GT(reference.shape_map.distortion, 4.3);
  EXPECT_NEAR(of_reference(), reference.shape_map.distortion, 0.02 * reference.shape_map.distortion);
}

TEST_F(RegisterGroup, WithoutBendingItIsFartherFromTheTruth) {
  const std::vector<Mesh> shapes = cohort();
  const Reference reference = map_reference(shapes[0], ctx);
  RegisterGroupOptions options = small();
  options.round_limit = 0;
  const double smooth = mean_error(shapes, register_group(shapes, reference, 0, ctx, options));
  options.bending = Bending::rigid;
  EXPECT_GT(mean_error(shapes, register_group(shapes, reference, 0, ctx, options)), 1.2 * smooth);
}

TEST_F(RegisterGroup, TheDescriptionLengthNeverGrows) {
  const std::vector<Mesh> shapes = cohort();
  RegisterGroupOptions options = small();
  options.round_limit = 0;
  options.description_rounds = 3;
  options.lambda = 1e-3;  // so that the distortion hardly contributes to the energy
  const GroupRegistration group = register_group(shapes, map_reference(shapes[0], ctx), 0, ctx, options);
  ASSERT_EQ(group.description_lengths.size(), 4u);
  for (std::size_t k = 1; k < 4; ++k)
    EXPECT_LE(group.description_lengths[k], group.description_lengths[k - 1]);
}

TEST_F(RegisterGroup, AMemberRegisteredToTheGroupAnewLiesWhereItLay) {
  const std::vector<Mesh> shapes = cohort();
  const Reference reference = map_reference(shapes[0], ctx);
  const GroupRegistration group = register_group(shapes, reference, 0, ctx, small());
  ASSERT_EQ(group.last_template.rounds, 2);
  Rng rng(8);
  const RigidTransform pose = testing::random_pose(rng);
  const Mesh moved = transformed(shapes[2], pose);
  const RegisteredShape anew = register_to_group(moved, reference, group.last_template, ctx, small());
  EXPECT_TRUE(anew.shape_map.certificate.valid());
  const TorusLocator locator(moved, anew.shape_map.map);
  const VertexMap<Vec3> there(
      lift_to_surface(locator, group.members[2].registered->shape_map.map.turns.values()));
  double sum = 0;
  for (VertexId v : shapes[2].vertices()) sum += (there[v] - moved.position(v)).norm();
  EXPECT_LT(sum / shapes[2].vertex_count(), 0.1);
}

TEST_F(RegisterGroup, WithoutRoundsAShapeIsRegisteredAsAMemberIs) {
  const std::vector<Mesh> shapes = cohort();
  const Reference reference = map_reference(shapes[0], ctx);
  RegisterGroupOptions options = small();
  options.round_limit = 0;
  const GroupRegistration group = register_group(shapes, reference, 0, ctx, options);
  const RegisteredShape anew = register_to_group(shapes[1], reference, group.last_template, ctx, options);
  EXPECT_EQ(anew.shape_map.map.turns, group.members[1].registered->shape_map.map.turns);
  options.description_rounds = 1;
  EXPECT_THROW(register_to_group(shapes[1], reference, group.last_template, ctx, options), InvalidInput);
}

TEST_F(RegisterGroup, ThreadsChangeNothing) {
  const std::vector<Mesh> shapes = cohort();
  const Reference reference = map_reference(shapes[0], ctx);
  RegisterGroupOptions options = small();
  options.round_limit = 1;
  const GroupRegistration one = register_group(shapes, reference, 0, RunContext(1), options);
  const GroupRegistration two = register_group(shapes, reference, 0, RunContext(2), options);
  for (std::size_t i = 0; i < shapes.size(); ++i)
    EXPECT_EQ(one.members[i].registered->shape_map.map.turns, two.members[i].registered->shape_map.map.turns);
}

TEST_F(RegisterGroup, AShapeThatFailsACheckIsLeftOutAndTheOthersGoOn) {
  std::vector<Mesh> shapes = cohort();
  // The loops of the reference have no counterpart on a knotted torus.
  shapes[2] = knotted_torus();
  const Reference reference = map_reference(shapes[0], ctx);
  const GroupRegistration group = register_group(shapes, reference, 0, ctx, small());
  EXPECT_FALSE(group.members[2].registered);
  EXPECT_THAT(group.members[2].failure.text, ::testing::HasSubstr("loops"));
  for (std::size_t i : {0u, 1u, 3u})
    EXPECT_TRUE(group.members[i].registered) << group.members[i].failure.text;
}

}  // namespace
}  // namespace foramen
