#include "io/vtk_data_array.hpp"

#include <algorithm>
#include <utility>

namespace foramen::io_detail {
namespace {

std::string without_blanks(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  std::copy_if(text.begin(), text.end(), std::back_inserter(out),
               [](char c) { return c != ' ' && c != '\n' && c != '\r' && c != '\t'; });
  return out;
}

constexpr std::uint64_t most_bytes = std::uint64_t{1} << 31U;

// The value of a base64 digit; -1 for any other character.
int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

}  // namespace

// A sequence of bytes, raw or in base64. In base64 every piece that is taken was encoded on its own.
class VtkDataArrays::Run {
 public:
  Run(const Source& source, std::string_view encoded, bool base64)
      : source_(source), rest_(encoded), base64_(base64) {}
  /// An upper bound for the length of a piece.
  std::size_t most() const { return base64_ ? rest_.size() / 4 * 3 : rest_.size(); }
  std::string peek(std::size_t count) const { return Run(*this).take(count); }
  std::string take(std::size_t count) {
    if (count > most()) source_.refuse("ends within the data of an array", remedy_export_again);
    const std::size_t length = base64_ ? (count + 2) / 3 * 4 : count;
    const std::string_view piece = rest_.substr(0, length);
    rest_.remove_prefix(length);
    std::string out = base64_ ? decoded(piece) : std::string(piece);
    if (out.size() < count) source_.refuse("ends within the data of an array", remedy_export_again);
    out.resize(count);
    return out;
  }

 private:
  std::string decoded(std::string_view text) const {
    std::string out;
    out.reserve(text.size() / 4 * 3);
    for (; text.size() >= 4; text.remove_prefix(4)) {
      const bool one = text[2] == '=', two = !one && text[3] == '=';  // decoded bytes in the last group
      std::uint32_t group = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const bool padding = (one && k >= 2) || (two && k == 3);
        const int digit = padding && text[k] == '=' ? 0 : base64_digit(text[k]);
        if (digit < 0)
          source_.refuse("holds " + in_quotes(text.substr(0, 4)) + " in base64 data", remedy_export_again);
        group = group << 6 | static_cast<std::uint32_t>(digit);
      }
      out += static_cast<char>(group >> 16);
      if (!one) out += static_cast<char>(group >> 8 & 0xff);
      if (!one && !two) out += static_cast<char>(group & 0xff);
    }
    return out;
  }

  const Source& source_;
  std::string_view rest_;
  bool base64_;
};

VtkDataArrays::VtkDataArrays(const Source& source, const XmlElement& file, std::string_view appended,
                             bool appended_base64)
    : source_(source),
      order_(file.attribute("byte_order") == "BigEndian" ? ByteOrder::big : ByteOrder::little),
      header_bytes_(file.attribute("header_type", "UInt32") == "UInt64" ? 8 : 4),
      appended_(appended_base64 ? without_blanks(appended) : std::string(appended)),
      appended_base64_(appended_base64) {
  const std::string compressor = file.attribute("compressor");
  if (compressor == "vtkZLibDataCompressor")
    packing_ = BlockPacking::zlib;
  else if (compressor == "vtkLZ4DataCompressor")
    packing_ = BlockPacking::lz4;
  else if (compressor == "vtkLZMADataCompressor")
    packing_ = BlockPacking::lzma;
  else if (!compressor.empty())
    source.refuse("is compressed by " + in_quotes(compressor), "write it without compression, or as PLY");
}

const XmlElement& VtkDataArrays::find(const XmlElement& parent, const std::string& name) const {
  for (const XmlElement& child : parent.children)
    if (child.name == "DataArray" && (child.attribute("Name") == name || parent.name == "Points"))
      return child;
  source_.refuse("has no array '" + name + "' in <" + parent.name + ">", remedy_export_again);
}

std::string VtkDataArrays::bytes(const XmlElement& array) const {
  const std::string format = array.attribute("format", "ascii");
  if (format == "binary") {
    const std::string text = without_blanks(array.text);
    return unpacked(Run(source_, text, true));
  }
  if (format != "appended")
    source_.refuse("has an array of the unknown format " + in_quotes(format), remedy_export_again);
  const auto offset = to_integer(array.attribute("offset"));
  if (!offset || *offset < 0 || *offset >= std::ssize(appended_))
    source_.refuse("has an array at " + in_quotes(array.attribute("offset")) + " of " +
                       std::to_string(appended_.size()) + " appended bytes",
                   remedy_export_again);
  return unpacked(Run(source_, std::string_view(appended_).substr(*offset), appended_base64_));
}

std::string VtkDataArrays::unpacked(Run run) const {
  if (packing_) return inflated(run);
  const std::string header = run.peek(header_bytes_);
  ByteCursor cursor(header, 0, order_);
  const std::uint64_t count =
      header_bytes_ == 8 ? cursor.read<std::uint64_t>() : cursor.read<std::uint32_t>();
  if (count > run.most())
    source_.refuse("announces an array of " + std::to_string(count) + " bytes, more than the file holds",
                   remedy_export_again);
  return run.take(header_bytes_ + count).substr(header_bytes_);
}

// Decompresses an array. Its header has the number of blocks, the uncompressed size of each block, that of
// the last block if it differs (else 0), and the compressed size of each block. The blocks follow.
std::string VtkDataArrays::inflated(Run& run) const {
  const auto sizes_in = [&](const std::string& header) {
    std::vector<std::uint64_t> sizes;
    for (ByteCursor cursor(header, 0, order_); cursor.remaining() >= header_bytes_;)
      sizes.push_back(header_bytes_ == 8 ? cursor.read<std::uint64_t>() : cursor.read<std::uint32_t>());
    return sizes;
  };
  const auto refuse = [&](const std::string& found) { source_.refuse(found, remedy_export_again); };
  const std::uint64_t blocks = sizes_in(run.peek(header_bytes_))[0];
  if (blocks > run.most())
    refuse("announces " + std::to_string(blocks) + " compressed blocks, more than it holds");
  const std::vector<std::uint64_t> sizes = sizes_in(run.take((3 + blocks) * header_bytes_));
  std::uint64_t packed = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    if (sizes[3 + b] > run.most() - packed) refuse("announces a compressed block larger than the file");
    packed += sizes[3 + b];
  }
  const std::string data = run.take(packed);
  std::string out;
  std::size_t at = 0;
  for (std::size_t b = 0; b < blocks; at += sizes[3 + b], ++b) {
    const std::uint64_t size = b + 1 == blocks && sizes[2] != 0 ? sizes[2] : sizes[1];
    const std::string_view block = std::string_view(data).substr(at, sizes[3 + b]);
    if (size > most_unpacked(*packing_, block.size()))
      refuse("announces a block that cannot be compressed so densely");
    if (out.size() + size > most_bytes) refuse("announces more than 2 GiB of decompressed data");
    const auto unpacked = unpack_block(*packing_, block, size);
    if (!unpacked) refuse("holds a damaged compressed block");
    out += *unpacked;
  }
  return out;
}

template <class Value>
std::vector<Value> VtkDataArrays::values(const XmlElement& array) const {
  std::vector<Value> out;
  if (array.attribute("format", "ascii") == "ascii") {
    TokenCursor tokens(array.text);
    for (std::string_view token = tokens.next(); !token.empty(); token = tokens.next()) {
      const auto value = [&] {
        if constexpr (std::is_integral_v<Value>)
          return to_integer(token);
        else
          return to_number(token);
      }();
      if (!value) source_.refuse("expected a number, found " + in_quotes(token), remedy_export_again);
      out.push_back(*value);
    }
    return out;
  }
  const std::string data = bytes(array), type = array.attribute("type");
  ByteCursor cursor(data, 0, order_);
  const auto read_as = [&]<class Stored>() {
    out.reserve(data.size() / sizeof(Stored));
    while (cursor.remaining() >= sizeof(Stored))
      out.push_back(static_cast<Value>(cursor.template read<Stored>()));
  };
  if (type == "Int8")
    read_as.template operator()<std::int8_t>();
  else if (type == "UInt8")
    read_as.template operator()<std::uint8_t>();
  else if (type == "Int16")
    read_as.template operator()<std::int16_t>();
  else if (type == "UInt16")
    read_as.template operator()<std::uint16_t>();
  else if (type == "Int32")
    read_as.template operator()<std::int32_t>();
  else if (type == "UInt32")
    read_as.template operator()<std::uint32_t>();
  else if (type == "Int64")
    read_as.template operator()<std::int64_t>();
  else if (type == "UInt64")
    read_as.template operator()<std::uint64_t>();
  else if (type == "Float32" && !std::is_integral_v<Value>)
    read_as.template operator()<float>();
  else if (type == "Float64" && !std::is_integral_v<Value>)
    read_as.template operator()<double>();
  else
    source_.refuse("has an array " + in_quotes(array.attribute("Name")) + " of type " + in_quotes(type),
                   remedy_other_format);
  return out;
}

std::vector<double> VtkDataArrays::numbers(const XmlElement& array) const { return values<double>(array); }

std::vector<std::int64_t> VtkDataArrays::integers(const XmlElement& array) const {
  return values<std::int64_t>(array);
}

std::string VtkDataArrays::text(const XmlElement& array) const {
  std::string out;
  if (array.attribute("format", "ascii") == "ascii")
    for (const std::int64_t code : integers(array)) out += static_cast<char>(code);
  else
    out = bytes(array);
  return out.substr(0, out.find('\0'));
}

}  // namespace foramen::io_detail
