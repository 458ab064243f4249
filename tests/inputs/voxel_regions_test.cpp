#include "inputs/voxel_regions.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/geometry.hpp"
#include "support/label_maps.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

using ::testing::ElementsAre;
using testing::torus_soup;

// Voxels of 1 mm around the surface, with label 3 where x < 0 and label 8 elsewhere.
LabelMap halves(const Mesh& surface) {
  const BoundingBox box = bounding_box(surface.positions());
  const int width =
      2 * static_cast<int>(std::ceil(box.high.cwiseAbs().cwiseMax(box.low.cwiseAbs()).maxCoeff())) + 2;
  return testing::labelled_lattice({width, width, width}, Mat3::Identity(),
                                   [](const Vec3& p) { return p.x() < 0 ? 3 : 8; });
}

std::string region_of(const RegionsOfShape& regions, int vertex) {
  return regions.of_vertex[vertex] < 0 ? "" : regions.names[regions.of_vertex[vertex]];
}

TEST(VoxelRegions, EveryVertexHasTheLabelOfItsSide) {
  const Mesh torus = build_mesh(torus_soup(40, 20));
  LabelMap map = halves(torus);
  map.names[8] = "right half";
  const RegionsOfShape lps = voxel_regions({&map, 1}, torus, AnatomicalSpace::lps),
                       ras = voxel_regions({&map, 1}, torus, AnatomicalSpace::ras);
  for (VertexId v : torus.vertices()) {
    const double x = torus.position(v).x();
    if (std::abs(x) < 1.5) continue;  // the border of the halves is between voxels
    EXPECT_EQ(region_of(lps, v.index), x < 0 ? "3" : "right half");
    EXPECT_EQ(region_of(ras, v.index), x < 0 ? "right half" : "3");
  }
}

TEST(VoxelRegions, FarFromAllVoxelsIsNoRegion) {
  const Mesh torus = build_mesh(torus_soup(40, 20));
  LabelMap map = halves(torus);
  for (std::uint16_t& label : map.labels) label = label == 3 ? 3 : 0;
  const RegionsOfShape regions = voxel_regions({&map, 1}, torus, AnatomicalSpace::lps);
  EXPECT_THAT(regions.names, ElementsAre("3"));
  for (VertexId v : torus.vertices()) {
    const double x = torus.position(v).x();
    if (x > -1 && x < 4) continue;
    EXPECT_EQ(region_of(regions, v.index), x < 0 ? "3" : "");
  }
  std::fill(map.labels.begin(), map.labels.end(), 0);
  EXPECT_EQ(region_of(voxel_regions({&map, 1}, torus, AnatomicalSpace::lps), 0), "");
}

}  // namespace
}  // namespace foramen
