#include "io/voxel_layout.hpp"

#ifdef FORAMEN_WITH_ITK
#include <limits>
#include <string>

#include "io/file_bytes.hpp"
#include "io/unpack.hpp"

namespace foramen::io_detail {
namespace {

std::string by(const std::array<std::int64_t, 3>& size) {
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]);
}

}  // namespace

void check_layout(const std::filesystem::path& path, const VoxelLayout& layout) {
  const Source source{path.string(), {}};
  constexpr std::int64_t most_voxels = std::numeric_limits<std::int32_t>::max();
  std::int64_t voxels = 1;
  for (const std::int64_t n : layout.size) {
    if (n <= 0)
      source.refuse("its header announces " + by(layout.size) + " voxels", remedy_export_again);
    if (n > most_voxels / voxels)
      source.refuse("its header announces " + by(layout.size) + " voxels",
                    "that is more than foramen can hold: the header is damaged, or crop the label map");
    voxels *= n;
  }
  const std::int64_t needed = voxels * layout.voxel_bytes;
  const auto file_bytes = static_cast<std::int64_t>(require_readable(layout.data_file));
  const bool whole = layout.packing == VoxelLayout::Packing::whole;
  UnpackedSize found{file_bytes - layout.offset, true};
  if (layout.packing != VoxelLayout::Packing::none)
    found = unpacked_size(layout.data_file, whole ? 0 : layout.offset, whole ? layout.offset + needed : needed);
  if (whole) found.bytes -= layout.offset;
  if (found.bytes < needed)
    source.refuse("its header announces " + by(layout.size) + " voxels, which need " + std::to_string(needed) +
                      " bytes, but " + std::to_string(std::max<std::int64_t>(found.bytes, 0)) + " are there",
                  remedy_export_again);
  if (!found.intact) source.refuse("its compressed data are damaged", remedy_export_again);
}

}  // namespace foramen::io_detail
#endif
