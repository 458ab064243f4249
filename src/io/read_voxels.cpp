#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "io/voxel_layout.hpp"

namespace foramen::io_detail {
namespace {

class LabelReader {
 public:
  LabelReader(const Source& source, const VoxelLayout& layout)
      : source_(source), layout_(layout), stream_(layout.data_file, layout.offset, layout.packing) {
    count_ = layout.size[0] * layout.size[1] * layout.size[2] * layout.layers;
  }

  std::vector<std::uint16_t> read() {
    skip();
    switch (layout_.type.kind) {
      case NumberKind::unsigned_integer:
        return read_sized<std::uint8_t, std::uint16_t, std::uint32_t, std::uint64_t>();
      case NumberKind::signed_integer:
        return read_sized<std::int8_t, std::int16_t, std::int32_t, std::int64_t>();
      default:
        return layout_.type.bytes == 4 ? read_as<float>() : read_as<double>();
    }
  }

 private:
  static constexpr std::size_t chunk_voxels = std::size_t{1} << 16U;

  template <class One, class Two, class Four, class Eight>
  std::vector<std::uint16_t> read_sized() {
    switch (layout_.type.bytes) {
      case 1:
        return read_as<One>();
      case 2:
        return read_as<Two>();
      case 4:
        return read_as<Four>();
      default:
        return read_as<Eight>();
    }
  }

  template <class T>
  std::vector<std::uint16_t> read_as() {
    std::vector<std::uint16_t> labels;
    if (layout_.packing == ByteStream::Packing::none) labels.reserve(count_);
    std::vector<char> bytes(chunk_voxels * sizeof(T));
    while (std::ssize(labels) < count_) {
      const std::size_t wanted = std::min<std::size_t>(chunk_voxels, count_ - std::ssize(labels)) * sizeof(T);
      const std::size_t got = stream_.read(bytes.data(), wanted);
      ByteCursor cursor({bytes.data(), got - got % sizeof(T)}, 0, layout_.order);
      while (cursor.remaining() > 0)
        labels.push_back(as_label(static_cast<double>(cursor.template read<T>())));
      if (got < wanted) refuse_short(std::ssize(labels));
    }
    // The checksum of a compressed stream stands at its end, so one more byte is read to verify it.
    if (layout_.packing == ByteStream::Packing::deflate) stream_.read(bytes.data(), 1);
    if (stream_.damaged()) source_.refuse("its compressed data are damaged", remedy_export_again);
    return labels;
  }

  std::uint16_t as_label(double stored) const {
    constexpr double largest = std::numeric_limits<std::uint16_t>::max();
    const double value = layout_.slope * stored + layout_.intercept;
    if (!(value >= 0 && value <= largest && value == std::floor(value)))
      source_.refuse(
          "a voxel has the value " + std::to_string(value) + ", which is no label (whole, 0 to 65535)",
          "give the label map, not the image or probabilities");
    return static_cast<std::uint16_t>(value);
  }

  void skip() {
    std::vector<char> bytes(chunk_voxels);
    for (std::int64_t left = layout_.skipped; left > 0;) {
      const std::size_t wanted = std::min<std::size_t>(bytes.size(), left);
      if (stream_.read(bytes.data(), wanted) < wanted) refuse_short(0);
      left -= static_cast<std::int64_t>(wanted);
    }
  }

  [[noreturn]] void refuse_short(std::int64_t voxels) const {
    source_.refuse("ends " + std::string(stream_.damaged() ? "or is damaged " : "") + "after " +
                       std::to_string(voxels) + " of " + std::to_string(count_) + " voxels",
                   remedy_export_again);
  }

  const Source& source_;
  const VoxelLayout& layout_;
  ByteStream stream_;
  std::int64_t count_ = 0;
};

}  // namespace

std::vector<std::uint16_t> read_voxels(const std::filesystem::path& path, const VoxelLayout& layout) {
  const Source source{path.string(), {}};
  return LabelReader(source, layout).read();
}

}  // namespace foramen::io_detail
