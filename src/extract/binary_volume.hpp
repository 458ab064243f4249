#pragma once
/// \file
/// Private to extract: the voxels of one label.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "foramen/extract/extract_label.hpp"
#include "foramen/io/label_map.hpp"

namespace foramen::extract {

/// A lattice of voxels, inside or outside, with one layer of outside around all that is inside. Its axes are
/// those of the label map in the order and direction nearest to left, posterior, superior, so
/// that the same voxels are the same volume however the map was stored.
struct BinaryVolume {
  std::array<int, 3> size{};
  std::vector<std::uint8_t> inside;    ///< 1 or 0; voxel (i, j, k) at (k * size[1] + j) * size[0] + i
  Mat3 axes = Mat3::Identity();        ///< as of a LabelMap
  Vec3 origin = Vec3::Zero();          ///< centre of voxel (0, 0, 0), LPS mm
  std::array<int, 3> first{}, last{};  ///< the voxels that lie in the label map

  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size[1]) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(size[0]) +
           static_cast<std::size_t>(i);
  }
  bool at(int i, int j, int k) const { return inside[index(i, j, k)] != 0; }
  Vec3 spacing() const { return axes.colwise().norm().transpose(); }
};

/// The voxels of the label, in a box around them.
BinaryVolume binary_volume(const LabelMap& map, int label, const LabelExtent& extent);

struct Cleaning {
  int components = 0;            ///< before
  std::int64_t kept_voxels = 0;  ///< of the largest component
  std::int64_t lost_voxels = 0;  ///< of the others
  std::int64_t filled_voxels = 0;
  std::vector<std::string> cut_at;  ///< sides of the label map that the largest component reaches
};

/// Keeps the largest component (the first of equals) and fills its cavities. With EdgeContact::joined inside
/// voxels are neighbours across a face or an edge (18) and outside ones across a face (6), with apart the
/// other way round.
Cleaning keep_largest_component(BinaryVolume& volume, EdgeContact contact);

}  // namespace foramen::extract
