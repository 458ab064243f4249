#include "io/voxel_layout.hpp"

#include <algorithm>
#include <array>
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
  const std::int64_t files = std::ssize(layout.data_files);
  if (voxels % files != 0)
    source.refuse(
        "its " + by(layout.size) + " voxels cannot be spread evenly over " + std::to_string(files) + " files",
        remedy_export_again);
  const std::int64_t needed = layout.skipped + voxels / files * layout.type.bytes;
  const bool packed = layout.packing == ByteStream::Packing::deflate;
  for (const std::filesystem::path& file : layout.data_files) {
    const auto size = static_cast<std::int64_t>(require_readable(file));
    const std::int64_t there = layout.at_end ? size : std::max<std::int64_t>(0, size - layout.offset);
    if (needed > (packed ? densest * (there + 1) : there))
      source.refuse("its header announces " + by(layout.size) + " voxels, which need " +
                        std::to_string(needed) + " bytes" + (files > 1 ? " in each file" : "") + ", but " +
                        std::to_string(there) + (packed ? " compressed ones" : "") + " are there" +
                        (files > 1 ? " in " + in_quotes(file.filename().string()) : ""),
                    remedy_export_again);
  }
}

}  // namespace

std::optional<GeometryProblem> geometry_problem(const Mat3& axes, const Vec3& origin) {
  const Vec3 spacing = axes.colwise().norm().transpose();
  constexpr double smallest_mm = 1e-3, largest_mm = 100, farthest_mm = 1e6;
  if (!spacing.allFinite() || spacing.minCoeff() < smallest_mm || spacing.maxCoeff() > largest_mm)
    return GeometryProblem{"its voxels measure " + millimetres(spacing), "correct the spacing in its header"};
  if (!origin.allFinite() || origin.cwiseAbs().maxCoeff() > farthest_mm)
    return GeometryProblem{"its origin is at " + millimetres(origin), "correct the origin in its header"};
  const Mat3 direction = axes * spacing.cwiseInverse().asDiagonal();
  constexpr double rounding = 1e-3;  // directions are often written with few digits
  if ((direction.transpose() * direction - Mat3::Identity()).cwiseAbs().maxCoeff() > rounding)
    return GeometryProblem{"its axes are not at right angles", "resample it to a rectangular lattice"};
  return std::nullopt;
}

void set_packing_by_content(VoxelLayout& layout) {
  std::array<char, 2> start{};
  ByteStream(layout.data_files.front(), layout.offset, ByteStream::Packing::none)
      .read(start.data(), start.size());
  const auto first = static_cast<unsigned char>(start[0]), second = static_cast<unsigned char>(start[1]);
  // A stream of zlib begins with its method, 8 in the low bits, and a check value in the second byte.
  constexpr unsigned check = 31, method_bits = 15, deflate = 8, largest_window = 0x78;
  const bool gzip = first == 0x1f && second == 0x8b;
  const bool zlib =
      first <= largest_window && (first & method_bits) == deflate && (256U * first + second) % check == 0;
  // Voxels may begin like a stream of zlib by chance (0x78 is an x), but hardly like one of gzip.
  if (layout.packing == ByteStream::Packing::none) {
    if (gzip && !layout.at_end) layout.packing = ByteStream::Packing::deflate;
  } else if (!gzip && !zlib) {
    layout.packing = ByteStream::Packing::none;
  }
}

std::int64_t data_offset(const VoxelLayout& layout, const std::filesystem::path& file) {
  if (!layout.at_end) return layout.offset;
  const std::int64_t voxels = layout.size[0] * layout.size[1] * layout.size[2];
  return static_cast<std::int64_t>(require_readable(file)) -
         voxels / std::ssize(layout.data_files) * layout.type.bytes;
}

void check_layout(const std::filesystem::path& path, const VoxelLayout& layout) {
  const Source source{path.string(), {}};
  check_size(source, layout);
  if (const auto problem = geometry_problem(layout.axes, layout.origin))
    source.refuse(problem->found, problem->remedy);
}

}  // namespace foramen::io_detail
