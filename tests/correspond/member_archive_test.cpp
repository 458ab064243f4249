// A shape on its way comes back whole, and goes on to the same bits.
#include "correspond/member_archive.hpp"
#include "parameterize/optimise_map.hpp"

#include <gtest/gtest.h>

#include "correspond/knobbly_family.hpp"

namespace foramen {
namespace {

class MemberArchive : public ::testing::Test {
 protected:
  const testing::MappedSurface input = testing::member_surface(1, 900);
  const WorkingMesh working = simplify(input.mesh, RunContext(1), {.target_vertices = 500});
  OptimisedMap map_of_working() const {
    OptimisedMap map;
    map.map.lattice = input.map.lattice;
    map.map.turns = VertexMap<Vec2>(working.mesh.vertex_count(), Vec2::Zero());
    map.map.jumps = HalfedgeMap<Vec2i>(working.mesh.halfedge_count(), Vec2i(3, -4));
    for (VertexId v : working.mesh.vertices()) map.map.turns[v] = input.map.turns[working.vertex_origin[v]];
    map.status = OptimiseStatus::iteration_limit;
    map.iterations = 11;
    map.initial_energy = 12.5;
    map.final_energy = 13.5;
    map.distortion = 14.5;
    map.energies = {15.5, 16.5};
    return map;
  }
};

TEST_F(MemberArchive, AWorkingMeshComesBackWithTheWayToItsInput) {
  ASSERT_FALSE(working.collapses.empty());
  const std::string bytes = to_bytes(working);
  const auto again = from_bytes<WorkingMesh>(bytes);
  EXPECT_EQ(to_bytes(again), bytes);
  EXPECT_EQ(again.mesh.soup().points, working.mesh.soup().points);
  EXPECT_EQ(again.mesh.triangles(), working.mesh.triangles());
  EXPECT_EQ(again.vertex_origin, working.vertex_origin);
  EXPECT_EQ(again.face_origin, working.face_origin);
  ASSERT_EQ(again.collapses.size(), working.collapses.size());
  for (std::size_t k = 0; k < working.collapses.size(); ++k) {
    EXPECT_EQ(again.collapses[k].removed, working.collapses[k].removed);
    EXPECT_EQ(again.collapses[k].kept, working.collapses[k].kept);
    EXPECT_EQ(again.collapses[k].dropped_faces, working.collapses[k].dropped_faces);
    EXPECT_EQ(again.collapses[k].dropped_corners, working.collapses[k].dropped_corners);
    EXPECT_EQ(again.collapses[k].moved_faces, working.collapses[k].moved_faces);
  }
}

TEST_F(MemberArchive, AStateComesBackWhole) {
  MemberState state;
  state.map = map_of_working();
  state.result.homology << 1, 2, 3, 4;
  state.to_template.translate(Vec3(5, 6, 7));
  state.bent = {Vec3(8, 9, 10), Vec3(11, 12, 13)};
  const std::string bytes = to_bytes(state);
  const auto again = from_bytes<MemberState>(bytes);
  EXPECT_EQ(to_bytes(again), bytes);
  EXPECT_EQ(again.map.map.turns, state.map.map.turns);
  EXPECT_EQ(again.map.map.jumps, state.map.map.jumps);
  EXPECT_EQ(again.map.status, state.map.status);
  EXPECT_EQ(again.map.iterations, state.map.iterations);
  EXPECT_EQ(again.map.initial_energy, state.map.initial_energy);
  EXPECT_EQ(again.map.final_energy, state.map.final_energy);
  EXPECT_EQ(again.map.distortion, state.map.distortion);
  EXPECT_EQ(again.map.energies, state.map.energies);
  EXPECT_EQ(again.result.homology, state.result.homology);
  EXPECT_EQ(again.to_template.matrix(), state.to_template.matrix());
  EXPECT_EQ(again.bent, state.bent);
}

}  // namespace
}  // namespace foramen
