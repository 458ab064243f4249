#include <gtest/gtest.h>

#include "correspond/register_group.hpp"
#include "correspond/register_shape.hpp"
#include "support/real_meshes.hpp"

namespace foramen {
namespace {

// The loops of this L2 cannot be carried to the last L5, whose processes differ most, but those of the mean
// can.
TEST(RegisterGroupRealData, AShapeFarFromTheReferenceIsRegisteredToTheMean) {
  FORAMEN_NEEDS_REAL_DATA();
  std::vector<Mesh> shapes;
  for (const char* name : {"lumbar/verse823_L2", "lumbar/verse823_L4", "lumbar/verse823_L5",
                           "lumbar/verse631_L4", "lumbar/verse631_L5"})
    shapes.push_back(testing::real_mesh(name));
  const RunContext ctx(2);
  RegisterGroupOptions options;
  options.round_limit = 1;
  const GroupRegistration group = register_group(shapes, map_reference(shapes[0], ctx), 0, ctx, options);
  for (const GroupMember& member : group.members) {
    EXPECT_EQ(member.failure.text, "");
    ASSERT_TRUE(member.registered);
    EXPECT_TRUE(member.registered->shape_map.certificate.valid());
  }
}

}  // namespace
}  // namespace foramen
