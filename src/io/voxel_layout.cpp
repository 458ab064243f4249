#include "io/voxel_layout.hpp"

#include <algorithm>
#include <limits>
#include <string>

namespace foramen::io_detail {
namespace {

std::string by(const std::array<std::int64_t, 3>& size) {
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]);
}

std::string millimetres(const Vec3& v) {
  return std::to_string(v.x()) + " x " + std::to_string(v.y()) + " x " + std::to_string(v.z()) + " mm";
}

void check_size(const Source& source, const VoxelLayout& layout) {
  constexpr std::int64_t most_voxels = std::numeric_limits<std::int32_t>::max();
  std::int64_t voxels = 1;
  for (const std::int64_t n : layout.size) {
    if (n <= 0) source.refuse("its header announces " + by(layout.size) + " voxels", remedy_export_again);
    if (n > most_voxels / voxels)
      source.refuse("its header announces " + by(layout.size) + " voxels",
                    "that is more than foramen can hold: the header is damaged, or crop the label map");
    voxels *= n;
  }
  if (layout.layers > most_voxels / voxels)
    source.refuse(
        "its header announces " + std::to_string(layout.layers) + " layers of " + by(layout.size) + " voxels",
        "that is more than foramen can hold: the header is damaged, or save fewer segments");
  voxels *= layout.layers;
  // Deflate packs at most about 1032 bytes into one.
  constexpr std::int64_t densest = 1032;
  const std::int64_t needed = layout.skipped + voxels * layout.type.bytes;
  const std::int64_t there = std::max<std::int64_t>(
      0, static_cast<std::int64_t>(require_readable(layout.data_file)) - layout.offset);
  const bool packed = layout.packing == ByteStream::Packing::deflate;
  if (needed > (packed ? densest * (there + 1) : there))
    source.refuse("its header announces " + by(layout.size) + " voxels, which need " +
                      std::to_string(needed) + " bytes, but " + std::to_string(there) +
                      (packed ? " compressed ones" : "") + " are there",
                  remedy_export_again);
}

void check_geometry(const Source& source, const VoxelLayout& layout) {
  const Vec3 spacing = layout.axes.colwise().norm().transpose();
  constexpr double smallest_mm = 1e-3, largest_mm = 100, farthest_mm = 1e6;
  if (!spacing.allFinite() || spacing.minCoeff() < smallest_mm || spacing.maxCoeff() > largest_mm)
    source.refuse("its voxels measure " + millimetres(spacing), "correct the spacing in its header");
  if (!layout.origin.allFinite() || layout.origin.cwiseAbs().maxCoeff() > farthest_mm)
    source.refuse("its origin is at " + millimetres(layout.origin), "correct the origin in its header");
  const Mat3 direction = layout.axes * spacing.cwiseInverse().asDiagonal();
  constexpr double rounding = 1e-3;  // directions are often written with few digits
  if ((direction.transpose() * direction - Mat3::Identity()).cwiseAbs().maxCoeff() > rounding)
    source.refuse("its axes are not at right angles", "resample it to a rectangular lattice");
}

}  // namespace

void check_layout(const std::filesystem::path& path, const VoxelLayout& layout) {
  const Source source{path.string(), {}};
  check_size(source, layout);
  check_geometry(source, layout);
}

}  // namespace foramen::io_detail
