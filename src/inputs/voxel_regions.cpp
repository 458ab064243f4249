#include "inputs/voxel_regions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/LU>

#include "spatial/point_index.hpp"

namespace foramen {
namespace {

constexpr double farthest_mm = 3;

// The centres of voxels that touch one of another label, in LPS, and their regions. The labelled voxel that
// is closest to a point outside of all segments is one of them.
struct LabelledVoxels {
  std::vector<Vec3> centres;
  std::vector<int> regions;
};

bool is_at_a_border(const LabelMap& map, int i, int j, int k) {
  const std::array<int, 3> here{i, j, k};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int step : {-1, 1}) {
      std::array<int, 3> next = here;
      next[axis] += step;
      if (next[axis] < 0 || next[axis] >= map.size[axis] ||
          map.at(next[0], next[1], next[2]) != map.at(i, j, k))
        return true;
    }
  return false;
}

std::string name_of(const LabelMap& map, int label) {
  const auto found = map.names.find(label);
  return found == map.names.end() ? std::to_string(label) : found->second;
}

int index_of(const std::string& name, std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  names.push_back(name);
  return static_cast<int>(names.size()) - 1;
}

// The label of the voxel that contains a point in LPS; 0 outside of the map.
int label_at(const LabelMap& map, const Vec3& p) {
  const Vec3 steps = map.axes.inverse() * (p - map.origin);
  std::array<int, 3> voxel{};
  for (int axis = 0; axis < 3; ++axis) {
    const double nearest = std::round(steps[axis]);
    if (!(nearest >= 0 && nearest < map.size[axis])) return 0;
    voxel[axis] = static_cast<int>(nearest);
  }
  return map.at(voxel[0], voxel[1], voxel[2]);
}

void add_voxels(const LabelMap& map, std::vector<std::string>& names, LabelledVoxels& voxels) {
  for (int k = 0; k < map.size[2]; ++k)
    for (int j = 0; j < map.size[1]; ++j)
      for (int i = 0; i < map.size[0]; ++i) {
        const int label = map.at(i, j, k);
        if (label == 0 || !is_at_a_border(map, i, j, k)) continue;
        voxels.centres.emplace_back(map.origin + map.axes * Vec3(i, j, k));
        voxels.regions.push_back(index_of(name_of(map, label), names));
      }
}

}  // namespace

RegionsOfShape voxel_regions(std::span<const LabelMap> layers, const Mesh& surface, AnatomicalSpace space) {
  RegionsOfShape regions;
  regions.of_vertex.assign(surface.vertex_count(), -1);
  LabelledVoxels voxels;
  for (const LabelMap& map : layers) add_voxels(map, regions.names, voxels);
  if (voxels.centres.empty()) return regions;
  const PointIndex index(voxels.centres);
  for (VertexId v : surface.vertices()) {
    Vec3 p = surface.position(v);
    if (space == AnatomicalSpace::ras) p.head<2>() *= -1;
    int& region = regions.of_vertex[v.index];
    for (const LabelMap& map : layers)
      if (const int label = label_at(map, p); label != 0 && region < 0)
        region = index_of(name_of(map, label), regions.names);
    if (region >= 0) continue;
    const NearPoint near = index.nearest(p);
    if (near.distance() <= farthest_mm) region = voxels.regions[near.index];
  }
  return regions;
}

}  // namespace foramen
