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

/// A binary lattice of voxels, with at least one layer of outside voxels around the inside ones. Its axes are
/// those of the label map, permuted and reversed to be nearest to left, posterior, superior. The volume
/// therefore does not depend on how the map stores its axes.
struct BinaryVolume {
  std::array<int, 3> size{};
  std::vector<std::uint8_t> inside;    ///< 1 or 0; voxel (i, j, k) at (k * size[1] + j) * size[0] + i
  Mat3 axes = Mat3::Identity();        ///< as in LabelMap
  Vec3 origin = Vec3::Zero();          ///< centre of voxel (0, 0, 0), LPS mm
  std::array<int, 3> first{}, last{};  ///< first and last voxel that lie in the label map

  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size[1]) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(size[0]) +
           static_cast<std::size_t>(i);
  }
  bool at(int i, int j, int k) const { return inside[index(i, j, k)] != 0; }
  Vec3 spacing() const { return axes.colwise().norm().transpose(); }
};

/// The voxels of a label in a box around them.
BinaryVolume binary_volume(const LabelMap& map, int label, const LabelExtent& extent);

struct Cleaning {
  int components = 0;            ///< components before cleaning
  std::int64_t kept_voxels = 0;  ///< voxels of the largest component
  std::int64_t lost_voxels = 0;  ///< voxels of the other components
  std::int64_t filled_voxels = 0;
  std::vector<std::string> cut_at;  ///< sides of the label map that the largest component reaches
};

/// Keeps the largest component (the first of equally large ones) and fills its cavities. With
/// EdgeContact::joined, inside voxels are neighbours across faces and edges (18) and outside voxels across
/// faces (6). With EdgeContact::apart it is the reverse.
Cleaning keep_largest_component(BinaryVolume& volume, EdgeContact contact);

}  // namespace foramen::extract
