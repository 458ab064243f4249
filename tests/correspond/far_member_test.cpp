#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "correspond/off_centre_hole.hpp"
#include "correspond/register_group.hpp"
#include "correspond/register_shape.hpp"
#include "foramen/correspond/correspond.hpp"

namespace foramen {
namespace {

using testing::plate_with_hole;

RegisterGroupOptions only_aligned_at_first() {
  RegisterGroupOptions options;
  options.bending = Bending::rigid;  // bending would move the hole and so hide what is tested
  options.mean = {.vertices = 1500, .grid_points = 6000};
  options.round_limit = 0;
  return options;
}

std::vector<Mesh> plates(std::initializer_list<double> holes_mm) {
  std::vector<Mesh> shapes;
  for (double hole : holes_mm) shapes.push_back(plate_with_hole(hole));
  return shapes;
}

std::vector<bool> registered(const GroupRegistration& group) {
  std::vector<bool> is;
  for (const GroupMember& member : group.members) is.push_back(member.registered.has_value());
  return is;
}

const RunContext ctx{2};

// Two shapes alone have no mean, so the first group shows that the far shape fails with the reference.
TEST(AMemberFarFromTheReference, IsRegisteredByWayOfTheMean) {
  const Reference reference = map_reference(plate_with_hole(-10), ctx);
  const RegisterGroupOptions options = only_aligned_at_first();
  const GroupRegistration without = register_group(plates({-10, 10}), reference, 0, ctx, options);
  EXPECT_THAT(registered(without), ::testing::ElementsAre(true, false));
  const Message& failure = without.members[1].failure;
  EXPECT_THAT(failure.text, ::testing::HasSubstr("determinant"));
  EXPECT_THAT(failure.text,
              ::testing::Not(::testing::HasSubstr("repair")));  // nothing is wrong with the shape
  EXPECT_TRUE(failure.remedies.empty());

  const GroupRegistration with = register_group(plates({-10, 0, 1, 2, 10}), reference, 0, ctx, options);
  for (const GroupMember& member : with.members) {
    ASSERT_TRUE(member.registered) << member.failure.text;
    EXPECT_EQ(member.failure.text, "");
    EXPECT_TRUE(member.registered->shape_map.certificate.valid());
  }
}

// The plate of median size is the first reference, but none of the others can be registered with it, and too
// few are left for a mean.
TEST(AReference, ThatLosesManyIsChanged) {
  const std::vector<Shape> shapes{{"far", plate_with_hole(-10)},
                                  {"small", plate_with_hole(9, 0.95)},
                                  {"near", plate_with_hole(10, 0.97)},
                                  {"large", plate_with_hole(11, 1.03)}};
  ASSERT_EQ(rank_references(shapes).front(), 0);
  CorrespondOptions options;
  options.group = only_aligned_at_first();
  const CohortRegistration found = correspond(shapes, options, ctx).registration;
  ASSERT_EQ(found.refused_references.size(), 1u);
  EXPECT_EQ(found.refused_references[0].name, "far");
  EXPECT_EQ(found.refused_references[0].reason.text, "3 of 4 shapes could not be registered with it");
  EXPECT_NE(found.shapes[found.reference].name, "far");
  EXPECT_EQ(found.shapes.size() + found.failed.size(), 4u);
  EXPECT_GE(found.shapes.size(), 3u);
}

}  // namespace
}  // namespace foramen
