// An interrupted registration of a group continues from its kept stages and gives the same bits.
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "correspond/member_archive.hpp"
#include "correspond/register_group.hpp"
#include "correspond/register_shape.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/correspond/registration_options.hpp"
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
          group.template_motion_mm, group.unexplained_shares, group.description_lengths);
    const DisplacementPrior& prior = group.last_template.prior;
    bytes(prior.variance, prior.mean, prior.directions);
    return bytes.take();
  }
};

TEST_F(ResumedGroup, EndsAsIfItHadNotBeenStoppedWhereverItWas) {
  const std::vector<Mesh> shapes = cohort();
  const Reference reference = map_reference(shapes[0], RunContext(1));
  const GroupRegistration group = register_group(shapes, reference, 0, RunContext(1), small());
  for (const GroupMember& member : group.members) ASSERT_EQ(member.failure.text, "");
  const std::string undisturbed = bytes_of(group);

  const auto whole = std::make_shared<MemoryStore>();
  EXPECT_EQ(bytes_of(register_group(shapes, reference, 0, RunContext(2).with_store(whole), small())),
            undisturbed);
  constexpr int steps = 5;   // working mesh, first registration, a round, a round by description, finish
  constexpr int common = 5;  // the reference's template, the mean, the priors, and twice the description
  ASSERT_EQ(whole->size(), steps * std::ssize(shapes) + common);
  constexpr int in_registrations = 6, mean = 8, priors = 9, description = 13;
  for (const int stop_at : {in_registrations, mean, priors, description}) {
    const auto store = std::make_shared<MemoryStore>();
    const RunContext first = RunContext(1).with_store(store);
    store->stop(first, stop_at);
    EXPECT_THROW(register_group(shapes, reference, 0, first, small()), Cancelled);
    EXPECT_EQ(store->size(), stop_at);
    std::set<std::string> reported;
    const RunContext second =
        RunContext(1, [&](const Progress& progress) { reported.emplace(progress.stage); }).with_store(store);
    EXPECT_EQ(bytes_of(register_group(shapes, reference, 0, second, small())), undisturbed) << stop_at;
    EXPECT_EQ(store->loads, stop_at) << "every finished step is taken up";
    EXPECT_EQ(store->kept_twice, 0) << "and not done again";
    EXPECT_EQ(store->entries(), whole->entries());
    EXPECT_EQ(reported.contains("mean"), stop_at < mean) << "what was made together is not made again";
    EXPECT_EQ(reported.contains("place"), stop_at < priors);
  }
}

// A store that gives one shape's first map with a vertex out of place.
class SpoilingStore : public MemoryStore {
 public:
  std::optional<std::string> load(const std::string& key) override {
    auto bytes = MemoryStore::load(key);
    if (!bytes || key != spoilt) return bytes;
    ByteReader reader(*bytes);
    auto kind = detail::KeptKind::result;
    MemberState state;
    reader(kind, state);
    state.map.map.turns[VertexId(0)] += Vec2(0.3, 0.4);
    return to_bytes(kind) + to_bytes(state);
  }
  std::string spoilt;
};

// Keys of a store's entries by stage.
std::set<std::string> keys_of(const MemoryStore& store, const std::string& stage) {
  std::set<std::string> keys;
  for (const auto& [key, bytes] : store.entries())
    if (key.starts_with(stage + " ")) keys.insert(key);
  return keys;
}

TEST_F(ResumedGroup, WhatIsMadeTogetherIsNamedByThoseThatHadAPartInIt) {
  const std::vector<Mesh> shapes = cohort();
  const Reference reference = map_reference(shapes[0], RunContext(1));
  const auto store = std::make_shared<SpoilingStore>();
  RegisterGroupOptions options = small();
  options.round_limit = 0;
  options.description_rounds = 0;
  const RunContext ctx = RunContext(1).with_store(store);
  register_group({shapes[0], shapes[1]}, reference, 0, ctx, options);
  const std::set<std::string> sound = keys_of(*store, "register");
  register_group(shapes, reference, 0, ctx, options);
  for (const std::string& key : keys_of(*store, "register"))
    if (!sound.contains(key)) store->spoilt = key;

  options.round_limit = 1;
  const GroupRegistration group = register_group(shapes, reference, 0, ctx, options);
  EXPECT_THAT(group.members[2].failure.text, ::testing::HasSubstr("no positive area"));
  const auto of_the_others = std::make_shared<MemoryStore>();
  const GroupRegistration others =
      register_group({shapes[0], shapes[1]}, reference, 0, RunContext(1).with_store(of_the_others), options);
  EXPECT_EQ(group.last_template.grid, others.last_template.grid);
  EXPECT_EQ(keys_of(*store, "group's mean").size(), 1u) << "none of all three";
  EXPECT_EQ(bytes_of(register_group(shapes, reference, 0, ctx, options)), bytes_of(group));
  EXPECT_EQ(store->kept_twice, 0);
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
  EXPECT_EQ(keys_of(*store, "group's mean").size(), 1u);
  EXPECT_EQ(keys_of(*store, "group's priors").size(), 1u);
  EXPECT_EQ(keys_of(*store, "round").size(), 6u);

  options.cohort.noise_mm *= 2;  // decides the priors, and with them the rounds
  register_group(shapes, reference, 0, ctx, options);
  EXPECT_EQ(keys_of(*store, "group's mean").size(), 1u);
  EXPECT_EQ(keys_of(*store, "group's priors").size(), 2u);
  EXPECT_EQ(keys_of(*store, "round").size(), 9u);

  shapes.push_back(transformed(shapes[1], RigidTransform(Eigen::Translation3d(1, 2, 3))));
  register_group(shapes, reference, 0, ctx, options);
  EXPECT_EQ(keys_of(*store, "working").size(), 4u) << "a further shape renames no other's first steps";
  EXPECT_EQ(keys_of(*store, "register").size(), 4u);
  EXPECT_EQ(keys_of(*store, "reference's template").size(), 1u);
  EXPECT_EQ(keys_of(*store, "group's mean").size(), 2u);
  EXPECT_EQ(keys_of(*store, "round").size(), 13u) << "but all depend on the new mean";
}

}  // namespace
}  // namespace foramen
