#pragma once
/// \file
/// Private to io: the content of a label map's header.

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

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
  std::int64_t layers = 1;             ///< labels at each voxel, stored side by side
  NumberType type;
  ByteOrder order = ByteOrder::little;
  double slope = 1, intercept = 0;  ///< label = slope * stored value + intercept
  /// The file of the header itself, another one, or several that each hold as many voxels.
  std::vector<std::filesystem::path> data_files;
  std::int64_t offset = 0;  ///< where the data or their compressed stream begin in each file, bytes
  bool at_end = false;      ///< the data are the last bytes of each file, whatever the offset
  ByteStream::Packing packing = ByteStream::Packing::none;
  std::int64_t skipped = 0;        ///< bytes before the voxels after decompression
  Mat3 axes = Mat3::Zero();        ///< columns: the step to the next voxel along i, j, k, LPS mm
  Vec3 origin = Vec3::Zero();      ///< centre of the first voxel, LPS mm
  std::vector<std::string> notes;  ///< what was amiss in the header and how it was taken
  /// What the header calls the labels of each layer: empty, or one map a layer.
  std::vector<std::map<int, std::string>> names = {};
};

/// Each function throws IoError for a header that is damaged or that states something foramen does not read:
/// a number of dimensions other than three, colours, vectors, unusual number types, no orientation.
VoxelLayout nifti_layout(const std::filesystem::path& path);
VoxelLayout nrrd_layout(const std::filesystem::path& path);
VoxelLayout meta_layout(const std::filesystem::path& path);

/// What is wrong with axes and origin, and what to do; nullopt if nothing is.
struct GeometryProblem {
  std::string found, remedy;
};
std::optional<GeometryProblem> geometry_problem(const Mat3& axes, const Vec3& origin);

/// Sets the packing by the first bytes of the data, since headers and names of files are often wrong about
/// it.
void set_packing_by_content(VoxelLayout& layout);

/// Where the data begin in one of the files. \pre check_layout() accepts the layout
std::int64_t data_offset(const VoxelLayout& layout, const std::filesystem::path& file);

/// Throws IoError if the sizes in a header are impossible, the file is too small for them, or the axes are
/// not at right angles.
void check_layout(const std::filesystem::path& path, const VoxelLayout& layout);

struct VoxelLabels {
  std::vector<std::uint16_t> labels;  ///< with the layers of a voxel side by side
  double farthest_rounded = 0;  ///< the largest distance of a value from the label that it was taken for
};

/// Reads the labels. A value that went through a floating point number is rounded if it is within half a step
/// of the scaling, and at most 0.05, of a whole number. Memory grows with the data that are read and not with
/// the size that the header states. Throws IoError for too few bytes, damaged data and values that are no
/// labels.
VoxelLabels read_voxels(const std::filesystem::path& path, const VoxelLayout& layout);

}  // namespace foramen::io_detail
