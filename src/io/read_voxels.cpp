#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "io/voxel_layout.hpp"

namespace foramen::io_detail {
namespace {

std::string written(double value) {
  std::ostringstream text;
  text.precision(10);
  text << value;
  return text.str();
}

// The values of a map that holds one which is no label.
struct OddValues {
  std::optional<double> first;                                        // of the odd ones
  double low = std::numeric_limits<double>::infinity(), high = -low;  // of all values from there on
  bool fractions = false;

  void see(double value, bool odd) {
    if (odd && !first) first = value;
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
    fractions |= value != std::floor(value);
  }
  [[noreturn]] void refuse(const Source& source) const {
    const std::string range = "its values, from " + written(low) + " to " + written(high) + ", ";
    const std::string found = "a voxel has the value " + written(*first);
    if (std::isfinite(*first) && low >= 0 && high <= 1 && fractions)
      source.refuse(found + ": " + range + "are those of probabilities",
                    "give the label map, or set each voxel to 1 or 0 by a threshold first");
    if (low < 0)
      source.refuse(found + ": " + range + "are those of an image or a distance map, not labels",
                    "give the label map that belongs to it");
    source.refuse(found + ", which is no label (whole, 0 to 65535)",
                  "give the label map, not the image or probabilities");
  }
};

class LabelReader {
 public:
  LabelReader(const Source& source, const VoxelLayout& layout)
      : source_(source),
        layout_(layout),
        count_(layout.size[0] * layout.size[1] * layout.size[2] * layout.layers) {
    // Half a step of the scaling tells neighbouring labels apart; numbers without a step have been rounded
    // far less than 0.05.
    constexpr double most = 0.05, single_precision = 1e-5;  // the latter for values up to about 100
    const bool whole = layout.type.kind != NumberKind::real;
    tolerance_ = whole ? std::min(std::abs(layout.slope) / 2 + single_precision, most) : most;
  }

  VoxelLabels read() {
    if (layout_.packing == ByteStream::Packing::none) labels_.labels.reserve(count_);
    const std::int64_t files = std::ssize(layout_.data_files);
    for (const std::filesystem::path& file : layout_.data_files) {
      ByteStream stream(file, data_offset(layout_, file), layout_.packing);
      skip(stream);
      read_file(stream, std::ssize(labels_.labels) + count_ / files);
    }
    if (odd_.first) odd_.refuse(source_);
    return std::move(labels_);
  }

 private:
  static constexpr std::size_t chunk_voxels = std::size_t{1} << 16U;

  void read_file(ByteStream& stream, std::int64_t up_to) {
    switch (layout_.type.kind) {
      case NumberKind::unsigned_integer:
        return read_sized<std::uint8_t, std::uint16_t, std::uint32_t, std::uint64_t>(stream, up_to);
      case NumberKind::signed_integer:
        return read_sized<std::int8_t, std::int16_t, std::int32_t, std::int64_t>(stream, up_to);
      default:
        return layout_.type.bytes == 4 ? read_as<float>(stream, up_to) : read_as<double>(stream, up_to);
    }
  }

  template <class One, class Two, class Four, class Eight>
  void read_sized(ByteStream& stream, std::int64_t up_to) {
    switch (layout_.type.bytes) {
      case 1:
        return read_as<One>(stream, up_to);
      case 2:
        return read_as<Two>(stream, up_to);
      case 4:
        return read_as<Four>(stream, up_to);
      default:
        return read_as<Eight>(stream, up_to);
    }
  }

  template <class T>
  void read_as(ByteStream& stream, std::int64_t up_to) {
    std::vector<std::uint16_t>& labels = labels_.labels;
    std::vector<char> bytes(chunk_voxels * sizeof(T));
    while (std::ssize(labels) < up_to) {
      const std::size_t wanted = std::min<std::size_t>(chunk_voxels, up_to - std::ssize(labels)) * sizeof(T);
      const std::size_t got = stream.read(bytes.data(), wanted);
      ByteCursor cursor({bytes.data(), got - got % sizeof(T)}, 0, layout_.order);
      while (cursor.remaining() > 0)
        labels.push_back(as_label(static_cast<double>(cursor.template read<T>())));
      if (got < wanted) refuse_short(stream);
    }
    // The checksum of a compressed stream stands at its end, so one more byte is read to verify it.
    if (layout_.packing == ByteStream::Packing::deflate) stream.read(bytes.data(), 1);
    if (stream.damaged()) source_.refuse("its compressed data are damaged", remedy_export_again);
  }

  std::uint16_t as_label(double stored) {
    constexpr double largest = std::numeric_limits<std::uint16_t>::max();
    const double value = layout_.slope * stored + layout_.intercept, label = std::round(value);
    const bool odd = !(label >= 0 && label <= largest && std::abs(value - label) <= tolerance_);
    if (odd || odd_.first) odd_.see(value, odd);
    if (odd) return 0;
    labels_.farthest_rounded = std::max(labels_.farthest_rounded, std::abs(value - label));
    return static_cast<std::uint16_t>(label);
  }

  void skip(ByteStream& stream) {
    std::vector<char> bytes(chunk_voxels);
    for (std::int64_t left = layout_.skipped; left > 0;) {
      const std::size_t wanted = std::min<std::size_t>(bytes.size(), left);
      if (stream.read(bytes.data(), wanted) < wanted) refuse_short(stream);
      left -= static_cast<std::int64_t>(wanted);
    }
  }

  [[noreturn]] void refuse_short(const ByteStream& stream) const {
    source_.refuse("ends " + std::string(stream.damaged() ? "or is damaged " : "") + "after " +
                       std::to_string(labels_.labels.size()) + " of " + std::to_string(count_) + " voxels",
                   remedy_export_again);
  }

  const Source& source_;
  const VoxelLayout& layout_;
  std::int64_t count_ = 0;
  double tolerance_ = 0;
  VoxelLabels labels_;
  OddValues odd_;
};

}  // namespace

VoxelLabels read_voxels(const std::filesystem::path& path, const VoxelLayout& layout) {
  const Source source{path.string(), {}};
  return LabelReader(source, layout).read();
}

}  // namespace foramen::io_detail
