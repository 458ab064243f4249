// An interrupted registration of a group continues from its kept stages and gives the same bits.
#include <set>

#include <gtest/gtest.h>

#include "correspond/member_archive.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/correspond/register_group.hpp"
#include "support/lopsided_torus.hpp"
#include "support/memory_store.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

using testing::MemoryStore;

class ResumedGroup : public ::testing::Test {
 protected:
  static std::vector<Mesh> cohort() {
    std::vector<Mesh> shapes;
    for (int i = 0; i < 3; ++i) {
      Rng rng = Rng(5).fork(static_cast<std::uint64_t>(i));
      const testing::SmoothDisplacement displace(0.4, 90, rng.fork(0));
      TriangleSoup soup = testing::knobbly_torus_soup(40, 24);
      for (Vec3& p : soup.points) p = displace(p);
      shapes.push_back(build_mesh(std::move(soup)));
    }
    return shapes;
  }
  static RegisterGroupOptions small() {
    RegisterGroupOptions options;
    options.mean = {.vertices = 600, .grid_points = 2400};
    options.working_vertices = 700;  // fewer than the input has
    options.round_limit = 1;
    options.description_rounds = 1;
    return options;
  }
  static std::string bytes_of(const GroupRegistration& group) {
    ByteWriter bytes;
    for (const GroupMember& member : group.members) bytes(member.registered, member.failure);
    bytes(group.last_template.grid, group.last_template.surface.mesh, group.last_template.surface.map,
          group.template_motion_mm, group.description_lengths);
    return bytes.take();
  }
};

TEST_F(ResumedGroup, EndsAsIfItHadNotBeenStoppedWhereverItWas) {
  const std::vector<Mesh> shapes = cohort();
  const Reference reference = map_reference(shapes[0], RunContext(1));
  const GroupRegistration group = register_group(shapes, reference, 0, RunContext(1), small());
  for (const GroupMember& member : group.members) ASSERT_EQ(member.failure, "");
  const std::string undisturbed = bytes_of(group);

  const auto whole = std::make_shared<MemoryStore>();
  EXPECT_EQ(bytes_of(register_group(shapes, reference, 0, RunContext(2).with_store(whole), small())),
            undisturbed);
  constexpr int stages = 5;  // working mesh, first registration, a round, a round by description, finish
  ASSERT_EQ(whole->size(), stages * std::ssize(shapes));
  for (const int stop_at : {2, 8, 13}) {
    const auto store = std::make_shared<MemoryStore>();
    const RunContext first = RunContext(1).with_store(store);
    store->stop(first, stop_at);
    EXPECT_THROW(register_group(shapes, reference, 0, first, small()), Cancelled);
    EXPECT_EQ(store->size(), stop_at);
    const RunContext second = RunContext(1).with_store(store);
    EXPECT_EQ(bytes_of(register_group(shapes, reference, 0, second, small())), undisturbed) << stop_at;
    EXPECT_EQ(store->loads, stop_at) << "every finished step is taken up";
    EXPECT_EQ(store->kept_twice, 0) << "and not done again";
    EXPECT_EQ(store->entries(), whole->entries());
  }
}

// The keys of the entries of a stage in the store.
std::set<std::string> keys_of(const MemoryStore& store, const std::string& stage) {
  std::set<std::string> keys;
  for (const auto& [key, bytes] : store.entries())
    if (key.starts_with(stage + " ")) keys.insert(key);
  return keys;
}

TEST_F(ResumedGroup, OnlyWhatDependsOnAChangeIsComputedAnew) {
  std::vector<Mesh> shapes = cohort();
  const Reference reference = map_reference(shapes[0], RunContext(1));
  const auto store = std::make_shared<MemoryStore>();
  const RunContext ctx = RunContext(2).with_store(store);
  RegisterGroupOptions options = small();
  options.description_rounds = 0;
  register_group(shapes, reference, 0, ctx, options);
  ASSERT_EQ(keys_of(*store, "round").size(), 3u);

  options.again.iterations = 1;  // affects only the rounds with the mean
  register_group(shapes, reference, 0, ctx, options);
  EXPECT_EQ(keys_of(*store, "working").size(), 3u);
  EXPECT_EQ(keys_of(*store, "register").size(), 3u);
  EXPECT_EQ(keys_of(*store, "round").size(), 6u);

  shapes.push_back(transformed(shapes[1], RigidTransform(Eigen::Translation3d(1, 2, 3))));
  register_group(shapes, reference, 0, ctx, options);
  EXPECT_EQ(keys_of(*store, "working").size(), 4u) << "a further shape renames no other's first steps";
  EXPECT_EQ(keys_of(*store, "register").size(), 4u);
  EXPECT_EQ(keys_of(*store, "round").size(), 10u) << "but all depend on the new mean";
}

}  // namespace
}  // namespace foramen
