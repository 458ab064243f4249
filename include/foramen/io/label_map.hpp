#pragma once
/// \file
/// Label maps on disk: NIfTI-1, NRRD and MetaImage.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// A whole number for every voxel of a lattice; 0 is the background.
struct LabelMap {
  std::array<int, 3> size{};          ///< voxels along i, j, k; each > 0
  std::vector<std::uint16_t> labels;  ///< of voxel (i, j, k) at (k * size[1] + j) * size[0] + i
  Mat3 axes = Mat3::Identity();       ///< columns: from a voxel to the next along i, j, k, LPS mm; orthogonal
  Vec3 origin = Vec3::Zero();         ///< centre of voxel (0, 0, 0), LPS mm
  std::string sha256;                 ///< of the file's bytes; header, then data, where these are two files

  std::uint16_t at(int i, int j, int k) const {
    return labels[(static_cast<std::size_t>(k) * static_cast<std::size_t>(size[1]) +
                   static_cast<std::size_t>(j)) *
                      static_cast<std::size_t>(size[0]) +
                  static_cast<std::size_t>(i)];
  }
};

/// Whether the name is that of a label map: ends with one of label_map_extensions(), in any case.
bool is_label_map(const std::filesystem::path& path);
/// .nii .nii.gz .nrrd .nhdr .mha .mhd
const std::vector<std::string>& label_map_extensions();
/// The file name without such an extension.
std::string label_map_stem(const std::filesystem::path& path);

/// Reads one 3-D image of whole numbers 0 .. 65535, stored as integers or floats, in any orientation: NIfTI
/// by its sform if it has one, else its qform; NRRD in LPS, RAS or LAS space; MetaImage in LPS. No memory is
/// taken for what a header promises, only for what the file holds. Throws IoError naming the file, what was
/// found and what to do: a header that promises more than the file holds, a file cut off or damaged, other
/// than three dimensions, colours or vectors, axes not at right angles, no orientation, numbers that are no
/// labels (not whole, negative: an image).
LabelMap read_label_map(const std::filesystem::path& path);

}  // namespace foramen
