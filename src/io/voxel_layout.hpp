#pragma once
/// \file
/// Private to io: what the header of a label map says.

#include <array>
#include <cstdint>
#include <filesystem>

#include "io/file_bytes.hpp"
#include "io/unpack.hpp"

namespace foramen::io_detail {

enum class NumberKind { unsigned_integer, signed_integer, real };

struct NumberType {
  NumberKind kind = NumberKind::unsigned_integer;
  std::int64_t bytes = 1;
};

struct VoxelLayout {
  std::array<std::int64_t, 3> size{};  ///< voxels along i, j, k
  NumberType type;
  ByteOrder order = ByteOrder::little;
  double slope = 1, intercept = 0;  ///< label = slope * stored + intercept
  std::filesystem::path data_file;  ///< the file itself, or another beside it
  std::int64_t offset = 0;          ///< where its bytes begin, or their compressed stream
  ByteStream::Packing packing = ByteStream::Packing::none;
  std::int64_t skipped = 0;    ///< bytes before the voxels, unpacked
  Mat3 axes = Mat3::Zero();    ///< columns: from a voxel to the next along i, j, k, LPS mm
  Vec3 origin = Vec3::Zero();  ///< centre of the first voxel, LPS mm
};

/// Each throws IoError for a header that is damaged or says what foramen does not read: other than three
/// dimensions, colours, vectors, odd types, no orientation.
VoxelLayout nifti_layout(const std::filesystem::path& path);
VoxelLayout nrrd_layout(const std::filesystem::path& path);
VoxelLayout meta_layout(const std::filesystem::path& path);

/// What a header says must be possible: sizes, the bytes that the file can hold, a lattice at right angles.
/// Throws IoError.
void check_layout(const std::filesystem::path& path, const VoxelLayout& layout);

/// The labels. Memory is taken as bytes are there, not as the header promises. Throws IoError: too few bytes,
/// damaged ones, numbers that are no labels.
std::vector<std::uint16_t> read_voxels(const std::filesystem::path& path, const VoxelLayout& layout);

}  // namespace foramen::io_detail
