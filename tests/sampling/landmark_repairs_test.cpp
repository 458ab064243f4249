#include "sampling/landmark_repairs.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "foramen/sampling/landmark_mesh.hpp"
#include "sampling/mapped_cohort.hpp"

namespace foramen::detail {
namespace {

using testing::bent_spikes;
using testing::landmarks_of;
using testing::MappedCohort;
using testing::spikes;
using testing::walled_torus;

/// The landmarks on all shapes, checked completely after each change.
struct State {
  TorusTriangulation mesh;
  LiftedLandmarks lifted;
  std::vector<std::vector<std::pair<FaceId, FaceId>>> pairs;  // intersecting triangles of each shape

  State(const LandmarkMesh& landmarks, const MappedCohort& cohort)
      : mesh(landmarks.turns, landmarks.triangles, landmarks.jumps),
        lifted(cohort.shapes(), mesh, RunContext(1)) {
    look();
  }

  void look() {
    pairs.clear();
    for (int s = 0; s < lifted.shapes(); ++s) {
      lifted.refresh_surface(s, mesh);
      pairs.push_back(self_intersections(*lifted.surface(s)));
    }
  }

  GuiltTable guilt() const {
    GuiltTable table(pairs.size(), std::vector<Guilt>(mesh.face_slots()));
    for (int s = 0; s < lifted.shapes(); ++s) {
      for (int f = 0; f < mesh.face_slots(); ++f) {
        const auto [a, b, c] = mesh.corners(f);
        table[s][f].flipped = lifted.guilty(s, {lifted.point(s, a), lifted.point(s, b), lifted.point(s, c)});
      }
      for (const auto& [f, g] : pairs[s]) {
        ++table[s][f.index].meetings;
        ++table[s][g.index].meetings;
      }
    }
    return table;
  }

  /// Makes the change; returns the triangles that it changed.
  std::vector<int> make(const Repair& r) {
    std::vector<int> changed;
    if (r.kind == RepairKind::flip) {
      const int h = mesh.flip(r.element);
      changed = {h / 3, mesh.twin(h) / 3};
    } else {
      int v = r.element;
      if (r.kind == RepairKind::move) mesh.set_place(v, r.place);
      if (r.kind == RepairKind::split_edge) v = mesh.split_edge(r.element);
      if (r.kind == RepairKind::split_face) v = mesh.split_face(r.element);
      lifted.update(v, mesh.place(v));
      mesh.for_each_outgoing(v, [&](int h) { changed.push_back(h / 3); });
    }
    look();
    return changed;
  }
};

Guilt sum_over(const GuiltTable& guilt, const std::vector<int>& faces) {
  Guilt sum;
  for (const auto& of_shape : guilt)
    for (int f : faces) sum = sum + of_shape[f];
  return sum;
}

TEST(LandmarkRepairs, EachLeavesTheGuiltThatItForetold) {
  const auto contains = [](const std::vector<int>& faces, FaceId f) {
    return std::find(faces.begin(), faces.end(), f.index) != faces.end();
  };
  int with_flips = 0, with_meetings = 0, meeting_each_other = 0;
  const auto check = [&](const LandmarkMesh& landmarks, const MappedCohort& cohort) {
    const State before(landmarks, cohort);
    const GuiltTable guilt = before.guilt();
    for (int f = 0; f < before.mesh.face_slots(); ++f) {
      if (sum_over(guilt, {f}) == Guilt{}) continue;
      for (const Insertion insertion : {Insertion::none, Insertion::any}) {
        const Repair repair = best_repair(before.mesh, before.lifted, guilt, f, insertion);
        if (repair.kind == RepairKind::none) continue;
        State after = before;
        const std::vector<int> changed = after.make(repair);
        const Guilt left = sum_over(after.guilt(), changed);
        EXPECT_EQ(repair.guilt_after.flipped, left.flipped) << "face " << f;
        EXPECT_EQ(repair.guilt_after.meetings, left.meetings) << "face " << f;
        with_flips += left.flipped > 0;
        with_meetings += left.meetings > 0;
        for (const auto& of_shape : after.pairs)
          meeting_each_other += std::any_of(of_shape.begin(), of_shape.end(), [&](const auto& p) {
            return contains(changed, p.first) && contains(changed, p.second);
          });
      }
    }
  };
  check(landmarks_of(spikes(), 200), bent_spikes(0.04));
  check(landmarks_of(testing::torus(20000), 100),
        MappedCohort({walled_torus(0.01, 0.0, 0.15), testing::torus(6000)}));
  EXPECT_GT(with_flips, 5) << "the example needs changes that leave something";
  EXPECT_GT(with_meetings, 5);
  EXPECT_GT(meeting_each_other, 0);
}

}  // namespace
}  // namespace foramen::detail
