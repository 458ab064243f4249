#include "extract/voxel_surface.hpp"

#include <gtest/gtest.h>

#include <set>

#include "extract/cube_triangles.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/core/rng.hpp"
#include "foramen/topology/inspect_mesh.hpp"
#include "spatial/self_intersections.hpp"

namespace foramen::extract {
namespace {

constexpr EdgeContact contacts[] = {EdgeContact::joined, EdgeContact::apart};

// Voxels that are inside with this probability, surrounded by one layer of outside.
BinaryVolume random_volume(const std::array<int, 3>& size, double density, std::uint64_t seed) {
  BinaryVolume volume;
  for (std::size_t a = 0; a < 3; ++a) volume.size[a] = size[a] + 2;
  volume.inside.assign(volume.index(0, 0, volume.size[2]), 0);
  Rng rng(seed);
  for (int k = 1; k <= size[2]; ++k)
    for (int j = 1; j <= size[1]; ++j)
      for (int i = 1; i <= size[0]; ++i)
        volume.inside[volume.index(i, j, k)] = rng.uniform(0, 1) < density ? 1 : 0;
  return volume;
}

BinaryVolume cube_volume(unsigned corners) {
  BinaryVolume volume = random_volume({2, 2, 2}, 0, 1);
  for (int c = 0; c < 8; ++c)
    if ((corners >> c & 1U) != 0)
      volume.inside[volume.index(1 + (c & 1), 1 + (c >> 1 & 1), 1 + (c >> 2 & 1))] = 1;
  return volume;
}

// V - E + F - C of the cubical complex whose vertices are the voxels of that kind, neighbours across faces.
// Where two opposite corners of a cube are of the other kind and do not touch (neighbours across edges at
// most), the six between them fill a hexagon.
int euler_number_of_voxels(const BinaryVolume& volume, bool inside) {
  int euler = 0;
  for (int k = 0; k < volume.size[2]; ++k)
    for (int j = 0; j < volume.size[1]; ++j)
      for (int i = 0; i < volume.size[0]; ++i) {
        if (i + 1 < volume.size[0] && j + 1 < volume.size[1] && k + 1 < volume.size[2]) {
          unsigned of_kind = 0;
          for (int c = 0; c < 8; ++c)
            if (volume.at(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2 & 1)) == inside) of_kind |= 1U << c;
          for (int c = 0; c < 4; ++c)
            if (of_kind == (255U ^ 1U << c ^ 1U << (7 - c))) ++euler;
        }
        for (int cell = 0; cell < 8; ++cell) {  // a cell spans the axes whose bits are set
          bool all = true;
          for (int corner = 0; corner < 8; ++corner) {
            if ((corner & ~cell) != 0) continue;
            const int x = i + (corner & 1), y = j + (corner >> 1 & 1), z = k + (corner >> 2 & 1);
            all = all && x < volume.size[0] && y < volume.size[1] && z < volume.size[2] &&
                  volume.at(x, y, z) == inside;
          }
          if (all) euler += (__builtin_popcount(static_cast<unsigned>(cell)) % 2 == 0) ? 1 : -1;
        }
      }
  return euler;
}

// The surface bounds the inside and also the outside (with a point at infinity added), and its Euler number
// is twice that of either. The complex of euler_number_of_voxels() joins voxels only across faces, so it is
// applied to the side whose voxels are joined only across faces.
int expected_euler_number(const BinaryVolume& volume, EdgeContact contact) {
  return contact == EdgeContact::apart ? 2 * euler_number_of_voxels(volume, true)
                                       : 2 * (euler_number_of_voxels(volume, false) - 1);
}

void expect_closed_manifold(const BinaryVolume& volume, EdgeContact contact) {
  const TriangleSoup soup = voxel_surface(volume, contact);
  if (soup.points.empty()) return;
  const MeshReport report = inspect_mesh(soup);
  EXPECT_TRUE(report.closed() && report.manifold() && report.oriented());
  EXPECT_EQ(report.invalid_triangles + report.duplicate_vertices + report.unused_vertices, 0);
  EXPECT_EQ(report.euler_number, expected_euler_number(volume, contact));
  EXPECT_GT(report.volume, 0);
  EXPECT_TRUE(self_intersections(TriangleTree(build_mesh(soup))).empty());
}

TEST(CubeTriangles, EveryEdgeBetweenInsideAndOutsideHasItsVertex) {
  for (const EdgeContact contact : contacts)
    for (unsigned inside = 0; inside < 256; ++inside) {
      std::set<int> used, expected;
      for (const auto& t : cube_triangles(inside, contact)) used.insert(t.begin(), t.end());
      for (int e = 0; e < 12; ++e) {
        const CubeEdge edge = cube_edge(e);
        const int from = edge.from[0] + 2 * edge.from[1] + 4 * edge.from[2], to = from + (1 << edge.axis);
        if ((inside >> from & 1U) != (inside >> to & 1U)) expected.insert(e);
      }
      EXPECT_EQ(used, expected) << inside;
    }
}

TEST(VoxelSurface, ClosedManifoldForEveryCube) {
  for (const EdgeContact contact : contacts)
    for (unsigned corners = 1; corners < 256; ++corners) {
      SCOPED_TRACE(corners);
      expect_closed_manifold(cube_volume(corners), contact);
    }
}

TEST(VoxelSurface, ClosedManifoldForAnyVoxels) {
  std::uint64_t seed = 0;
  for (const EdgeContact contact : contacts)
    for (const double density : {0.05, 0.3, 0.5, 0.7, 0.95})
      for (int repeat = 0; repeat < 3; ++repeat) {
        SCOPED_TRACE(++seed);
        expect_closed_manifold(random_volume({9, 8, 7}, density, seed), contact);
      }
}

TEST(VoxelSurface, VoxelsThatTouchAlongAnEdgeAreJoinedOrNot) {
  const BinaryVolume diagonal = cube_volume(0b00001001);
  EXPECT_EQ(inspect_mesh(voxel_surface(diagonal, EdgeContact::joined)).components, 1);
  EXPECT_EQ(inspect_mesh(voxel_surface(diagonal, EdgeContact::apart)).components, 2);
}

TEST(VoxelBoundary, HasTheFacesOfTheVoxels) {
  const BinaryVolume volume = random_volume({5, 4, 6}, 0.4, 3);
  int voxels = 0, faces = 0;
  for (int k = 1; k + 1 < volume.size[2]; ++k)
    for (int j = 1; j + 1 < volume.size[1]; ++j)
      for (int i = 1; i + 1 < volume.size[0]; ++i) {
        if (!volume.at(i, j, k)) continue;
        ++voxels;
        faces += !volume.at(i - 1, j, k) + !volume.at(i + 1, j, k) + !volume.at(i, j - 1, k) +
                 !volume.at(i, j + 1, k) + !volume.at(i, j, k - 1) + !volume.at(i, j, k + 1);
      }
  const Mesh boundary = build_mesh(voxel_boundary(volume));
  EXPECT_EQ(boundary.face_count(), 2 * faces);
  EXPECT_NEAR(total_area(boundary), faces, 1e-9);
  EXPECT_NEAR(signed_volume(boundary), voxels, 1e-9);
}

TEST(KeepLargestComponent, LeavesOneSurface) {
  for (const EdgeContact contact : contacts)
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      SCOPED_TRACE(seed);
      BinaryVolume volume = random_volume({8, 9, 7}, 0.05 + 0.09 * static_cast<double>(seed), seed);
      const std::int64_t before = std::count(volume.inside.begin(), volume.inside.end(), 1);
      const Cleaning done = keep_largest_component(volume, contact);
      EXPECT_EQ(done.kept_voxels + done.lost_voxels, before);
      EXPECT_EQ(done.kept_voxels + done.filled_voxels,
                std::count(volume.inside.begin(), volume.inside.end(), 1));
      EXPECT_EQ(inspect_mesh(voxel_surface(volume, contact)).components, 1);
    }
}

TEST(KeepLargestComponent, FillsCavitiesAndDropsSpecks) {
  BinaryVolume volume = random_volume({7, 5, 5}, 0, 1);
  for (int k = 1; k <= 4; ++k)
    for (int j = 1; j <= 4; ++j)
      for (int i = 1; i <= 4; ++i) volume.inside[volume.index(i, j, k)] = 1;
  volume.inside[volume.index(2, 2, 2)] = volume.inside[volume.index(2, 2, 3)] = 0;
  volume.inside[volume.index(7, 5, 5)] = 1;
  const Cleaning done = keep_largest_component(volume, EdgeContact::joined);
  EXPECT_EQ(done.components, 2);
  EXPECT_EQ(done.kept_voxels, 62);
  EXPECT_EQ(done.lost_voxels, 1);
  EXPECT_EQ(done.filled_voxels, 2);
  EXPECT_TRUE(volume.at(2, 2, 2));
  EXPECT_FALSE(volume.at(7, 5, 5));
}

}  // namespace
}  // namespace foramen::extract
