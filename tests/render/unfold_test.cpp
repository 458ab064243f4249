#include "render/unfold.hpp"

#include <gtest/gtest.h>

#include "render/mapped_torus.hpp"

namespace foramen {
namespace {

using testing::mapped_torus;
using testing::MappedTorus;

EdgeMap<bool> cut_along(const MappedTorus& torus) {
  EdgeMap<bool> cut(torus.mesh.edge_count(), false);
  for (const auto& loop : torus.loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      cut[torus.mesh.edge(torus.mesh.find_halfedge(loop[i], loop[(i + 1) % loop.size()]))] = true;
  return cut;
}

// The shift from the edge in the face of h to the same edge in the face of its twin.
Vec2i apart(const Mesh& mesh, const UnfoldedMap& unfolded, HalfedgeId h) {
  return unfolded.shift[Mesh::next(mesh.twin(h))] - unfolded.shift[h];
}

TEST(Unfold, FacesKeepTheirShapesAndTouchUnlessCut) {
  const MappedTorus torus = mapped_torus(14, 9);
  const Mesh& mesh = torus.mesh;
  const EdgeMap<bool> cut = cut_along(torus);
  const UnfoldedMap unfolded = unfold(mesh, torus.map, cut);
  for (HalfedgeId h : mesh.halfedges()) {
    EXPECT_EQ(Vec2i(unfolded.shift[Mesh::next(h)] - unfolded.shift[h]), torus.map.jumps[h]);
    if (!cut[mesh.edge(h)]) {
      EXPECT_EQ(apart(mesh, unfolded, h), Vec2i::Zero());
    }
  }
}

// The lower side of the domain is left of the first loop, its right side left of the second loop.
TEST(Unfold, BothCopiesOfALoopAreOnePeriodApart) {
  const MappedTorus torus = mapped_torus(14, 9);
  const UnfoldedMap unfolded = unfold(torus.mesh, torus.map, cut_along(torus));
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t i = 0; i < torus.loops[k].size(); ++i) {
      const auto& loop = torus.loops[k];
      const HalfedgeId h = torus.mesh.find_halfedge(loop[i], loop[(i + 1) % loop.size()]);
      EXPECT_EQ(apart(torus.mesh, unfolded, h), k == 0 ? Vec2i(0, 1) : Vec2i(-1, 0));
    }
}

TEST(Unfold, WithoutACutEveryFaceStillStandsOnce) {
  const MappedTorus torus = mapped_torus(14, 9);
  const Mesh& mesh = torus.mesh;
  const UnfoldedMap unfolded = unfold(mesh, torus.map, EdgeMap<bool>(mesh.edge_count(), false));
  double area = 0;
  for (FaceId f : mesh.faces()) {
    const Vec2 a = unfolded.corner(mesh, torus.map, Mesh::halfedge(f, 0));
    const Vec2 b = unfolded.corner(mesh, torus.map, Mesh::halfedge(f, 1)) - a;
    const Vec2 c = unfolded.corner(mesh, torus.map, Mesh::halfedge(f, 2)) - a;
    area += (b.x() * c.y() - b.y() * c.x()) / 2;
  }
  EXPECT_NEAR(std::abs(area), 1, 1e-12);
}

}  // namespace
}  // namespace foramen
