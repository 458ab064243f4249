#include "extract/binary_volume.hpp"

#include <algorithm>
#include <cmath>

namespace foramen::extract {
namespace {

// For each of the directions L, P, S: the axis of the map that is nearest to it, and whether the axis is
// reversed.
struct Reordering {
  std::array<int, 3> source{0, 1, 2};
  std::array<bool, 3> reversed{};
};

Reordering nearest_to_lps(const Mat3& axes) {
  const Mat3 direction = axes.colwise().normalized();
  Reordering best;
  double best_sum = -1;
  std::array<int, 3> order{0, 1, 2};
  do {
    double sum = 0;
    for (int a = 0; a < 3; ++a) sum += std::abs(direction(a, order[a]));
    if (sum <= best_sum) continue;
    best_sum = sum;
    best.source = order;
  } while (std::next_permutation(order.begin(), order.end()));
  for (int a = 0; a < 3; ++a) best.reversed[a] = direction(a, best.source[a]) < 0;
  return best;
}

using Offset = std::array<int, 3>;

// Offsets of the 6 neighbours across faces, with `edges` also of the 12 across edges.
std::vector<Offset> neighbour_offsets(bool edges) {
  std::vector<Offset> offsets;
  for (int k = -1; k <= 1; ++k)
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        const int distance = std::abs(i) + std::abs(j) + std::abs(k);
        if (distance == 1 || (edges && distance == 2)) offsets.push_back({i, j, k});
      }
  return offsets;
}

// Writes `value` to `number` for the component of the voxel `seed`, whose voxels have the number 0 so far;
// returns its size.
std::int64_t flood(const BinaryVolume& volume, std::vector<std::int32_t>& number, const Offset& seed,
                   std::int32_t value, const std::vector<Offset>& offsets) {
  const std::uint8_t kind = volume.inside[volume.index(seed[0], seed[1], seed[2])];
  std::vector<Offset> front{seed};
  number[volume.index(seed[0], seed[1], seed[2])] = value;
  std::int64_t count = 0;
  while (!front.empty()) {
    const Offset at = front.back();
    front.pop_back();
    ++count;
    for (const Offset& o : offsets) {
      const Offset to{at[0] + o[0], at[1] + o[1], at[2] + o[2]};
      bool within = true;
      for (std::size_t a = 0; a < 3; ++a) within = within && to[a] >= 0 && to[a] < volume.size[a];
      if (!within) continue;
      const std::size_t index = volume.index(to[0], to[1], to[2]);
      if (number[index] != 0 || volume.inside[index] != kind) continue;
      number[index] = value;
      front.push_back(to);
    }
  }
  return count;
}

template <class Visit>
void for_each_voxel(const BinaryVolume& volume, const Visit& visit) {
  for (int k = 0; k < volume.size[2]; ++k)
    for (int j = 0; j < volume.size[1]; ++j)
      for (int i = 0; i < volume.size[0]; ++i) visit(Offset{i, j, k}, volume.index(i, j, k));
}

}  // namespace

BinaryVolume binary_volume(const LabelMap& map, int label, const LabelExtent& extent) {
  const Reordering order = nearest_to_lps(map.axes);
  BinaryVolume volume;
  volume.origin = map.origin;
  std::array<int, 3> start{}, step{};  // in indices of the map, by axis of the volume
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t s = order.source[a];
    const int low = extent.low[s], high = extent.high[s];
    const bool reversed = order.reversed[a];
    volume.size[a] = high - low + 3;
    step[a] = reversed ? -1 : 1;
    start[a] = reversed ? high + 1 : low - 1;
    volume.axes.col(static_cast<int>(a)) = step[a] * map.axes.col(static_cast<int>(s));
    volume.origin += start[a] * map.axes.col(static_cast<int>(s));
    volume.first[a] = reversed ? start[a] - (map.size[s] - 1) : -start[a];
    volume.last[a] = volume.first[a] + map.size[s] - 1;
  }
  volume.inside.assign(volume.index(0, 0, volume.size[2]), 0);
  for (int k = 1; k + 1 < volume.size[2]; ++k)
    for (int j = 1; j + 1 < volume.size[1]; ++j)
      for (int i = 1; i + 1 < volume.size[0]; ++i) {
        std::array<int, 3> source{};
        const std::array<int, 3> at{i, j, k};
        for (std::size_t a = 0; a < 3; ++a) source[order.source[a]] = start[a] + step[a] * at[a];
        if (map.at(source[0], source[1], source[2]) == label) volume.inside[volume.index(i, j, k)] = 1;
      }
  return volume;
}

Cleaning keep_largest_component(BinaryVolume& volume, EdgeContact contact) {
  Cleaning done;
  std::vector<std::int32_t> number(volume.inside.size(), 0);
  const bool joined = contact == EdgeContact::joined;
  const auto inside_offsets = neighbour_offsets(joined), outside_offsets = neighbour_offsets(!joined);
  std::int32_t largest = 0;
  std::int64_t all = 0;
  for_each_voxel(volume, [&](const Offset& at, std::size_t index) {
    if (volume.inside[index] == 0 || number[index] != 0) return;
    const auto count = flood(volume, number, at, ++done.components, inside_offsets);
    all += count;
    if (count > done.kept_voxels) {
      done.kept_voxels = count;
      largest = done.components;
    }
  });
  done.lost_voxels = all - done.kept_voxels;
  std::array<bool, 6> reached{};
  for_each_voxel(volume, [&](const Offset& at, std::size_t index) {
    volume.inside[index] = largest != 0 && number[index] == largest ? 1 : 0;
    if (volume.inside[index] == 0) return;
    for (std::size_t a = 0; a < 3; ++a) {
      reached[2 * a] = reached[2 * a] || at[a] == volume.first[a];
      reached[2 * a + 1] = reached[2 * a + 1] || at[a] == volume.last[a];
    }
  });
  constexpr std::array<const char*, 6> sides{"right",     "left",     "anterior",
                                             "posterior", "inferior", "superior"};
  for (std::size_t s = 0; s < sides.size(); ++s)
    if (reached[s]) done.cut_at.emplace_back(sides[s]);
  std::fill(number.begin(), number.end(), 0);
  flood(volume, number, {0, 0, 0}, 1, outside_offsets);
  for_each_voxel(volume, [&](const Offset&, std::size_t index) {
    if (volume.inside[index] != 0 || number[index] != 0) return;
    volume.inside[index] = 1;
    ++done.filled_voxels;
  });
  return done;
}

}  // namespace foramen::extract
