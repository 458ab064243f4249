#ifdef FORAMEN_WITH_ITK
#include <cmath>
#include <optional>

#include "io/file_bytes.hpp"
#include "io/unpack.hpp"
#include "io/voxel_layout.hpp"

namespace foramen::io_detail {
namespace {

constexpr std::int32_t header_bytes = 348, header_bytes_2 = 540;
constexpr const char* no_header = "it is no NIfTI file: check its format and extension";

// Bytes of a voxel by NIfTI's number of its type; nothing for what is no number.
std::optional<int> bytes_of_type(int type) {
  switch (type) {
    case 2:    // uint8
    case 256:  // int8
      return 1;
    case 4:    // int16
    case 512:  // uint16
      return 2;
    case 8:    // int32
    case 16:   // float32
    case 768:  // uint32
      return 4;
    case 64:    // float64
    case 1024:  // int64
    case 1280:  // uint64
      return 8;
    default:
      return std::nullopt;
  }
}

ByteOrder byte_order(const Source& source) {
  if (source.bytes.size() < static_cast<std::size_t>(header_bytes))
    source.refuse("has only " + std::to_string(source.bytes.size()) + " bytes, less than a NIfTI header",
                  remedy_export_again);
  for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
    const auto size = ByteCursor(source.bytes, 0, order).read<std::int32_t>();
    if (size == header_bytes_2)
      source.refuse("is a NIfTI-2 file", "foramen reads NIfTI-1: convert it, or save it as NRRD");
    if (size == header_bytes) return order;
  }
  source.refuse("does not begin as a NIfTI header does", no_header);
}

}  // namespace

VoxelLayout nifti_layout(const std::filesystem::path& path) {
  constexpr std::size_t dim_at = 40, type_at = 70, offset_at = 108, magic_at = 344;
  const std::string header = first_bytes(path, header_bytes);
  const Source source{path.string(), header};
  const ByteOrder order = byte_order(source);
  if (source.bytes.substr(magic_at, 3) != "n+1")
    source.refuse("has no NIfTI mark in its header",
                  "foramen reads NIfTI in one file (.nii, .nii.gz): convert it");
  ByteCursor dims(header, dim_at, order);
  const int dimensions = dims.read<std::int16_t>();
  VoxelLayout layout;
  for (auto& n : layout.size) n = dims.read<std::int16_t>();
  // Some programs write more dimensions than there are, of one element each.
  bool three = dimensions >= 3 && dimensions <= 7;
  for (int d = 3; three && d < dimensions; ++d) three = dims.read<std::int16_t>() == 1;
  if (!three)
    source.refuse("is an image of " + std::to_string(dimensions) + " dimensions",
                  "a label map has three: save one volume of it");
  const int type = ByteCursor(header, type_at, order).read<std::int16_t>();
  const auto bytes = bytes_of_type(type);
  if (!bytes)
    source.refuse("its voxels are of NIfTI type " + std::to_string(type) + " (colours, complex or odd numbers)",
                  "a label map holds one whole number a voxel");
  layout.voxel_bytes = *bytes;
  const double offset = ByteCursor(header, offset_at, order).read<float>();
  constexpr double farthest = 1e9;
  if (!(offset >= header_bytes && offset <= farthest))
    source.refuse("its header says that the voxels begin at byte " + std::to_string(offset),
                  remedy_export_again);
  layout.offset = static_cast<std::int64_t>(offset);
  layout.data_file = path;
  if (lower_case(path.extension().string()) == ".gz") layout.packing = VoxelLayout::Packing::whole;
  return layout;
}

}  // namespace foramen::io_detail
#endif
