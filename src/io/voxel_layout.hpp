#pragma once
/// \file
/// Private to io: what the header of a label map promises, read by our own code before any library allocates
/// for it.

#include <array>
#include <cstdint>
#include <filesystem>

namespace foramen::io_detail {

/// Where the voxels stand and how many bytes they take.
struct VoxelLayout {
  std::array<std::int64_t, 3> size{};  ///< voxels along i, j, k; not yet checked
  std::int64_t voxel_bytes = 0;
  std::filesystem::path data_file;  ///< the file itself, or another beside it
  std::int64_t offset = 0;          ///< of the voxels: in the data file, or, for packed_whole, in what it unpacks to
  enum class Packing { none, from_offset, whole } packing = Packing::none;  ///< gzip or zlib
};

/// Each throws IoError for what foramen does not read: other than three dimensions, colours, vectors, odd types.
VoxelLayout nifti_layout(const std::filesystem::path& path);
VoxelLayout nrrd_layout(const std::filesystem::path& path);
VoxelLayout meta_layout(const std::filesystem::path& path);

/// Throws IoError unless the data file holds all the voxels, unpacked and intact.
void check_layout(const std::filesystem::path& path, const VoxelLayout& layout);

}  // namespace foramen::io_detail
