#pragma once
/// \file
/// Private to io: the bytes of a file in memory and cursors that never read outside them.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "foramen/io/mesh_file.hpp"

namespace foramen::io_detail {

/// The bytes of one file and the name of the file for error messages.
struct Source {
  std::string name;
  std::string_view bytes;
  /// Throws IoError "name: found; remedy".
  [[noreturn]] void refuse(const std::string& found, const std::string& remedy) const;
};

/// The size of a file. Throws IoError if it is not a regular file or is empty.
std::uintmax_t require_readable(const std::filesystem::path& path);

/// The whole file. Throws IoError if it is not a regular file, cannot be read or is empty.
std::string read_bytes(const std::filesystem::path& path);

/// Part of a file for an error message: in quotes, at most 40 characters, without control characters that a
/// terminal would obey.
std::string in_quotes(std::string_view text);

/// Parses the whole token as a number; nullopt if it is none or out of range. "nan" and "inf" count as
/// numbers.
std::optional<double> to_number(std::string_view token);
std::optional<std::int64_t> to_integer(std::string_view token);

std::string lower_case(std::string_view text);

/// The number of bytes of the mark of UTF-8 at the beginning of a text: 3 or 0.
std::size_t byte_order_mark(std::string_view bytes);

/// A cursor over lines that end with LF or CRLF. A byte order mark before the first line is skipped.
class LineCursor {
 public:
  explicit LineCursor(std::string_view bytes) : bytes_(bytes), offset_(byte_order_mark(bytes)) {}
  /// Goes to the next line; false at the end.
  bool next();
  /// Goes to the next line that is not blank; false at the end.
  bool next_filled();
  std::string_view line() const { return line_; }
  /// "line 12"
  std::string place() const { return "line " + std::to_string(number_); }
  std::size_t number() const { return number_; }
  /// The first byte after the current line.
  std::size_t offset() const { return offset_; }
  std::size_t remaining() const { return bytes_.size() - offset_; }

 private:
  std::string_view bytes_, line_;
  std::size_t offset_ = 0, number_ = 0;
};

/// A cursor over the words of a line.
class TokenCursor {
 public:
  explicit TokenCursor(std::string_view line) : rest_(line) {}
  /// The next word; empty at the end.
  std::string_view next();
  /// The rest of the line without blanks at its ends.
  std::string_view rest() const;

 private:
  std::string_view rest_;
};

enum class ByteOrder { little, big };

/// A cursor that reads fixed-size binary values.
class ByteCursor {
 public:
  ByteCursor(std::string_view bytes, std::size_t offset, ByteOrder order)
      : bytes_(bytes), offset_(offset), order_(order) {}
  std::size_t offset() const { return offset_; }
  std::size_t remaining() const { return bytes_.size() - offset_; }
  /// \pre remaining() >= sizeof(T)
  template <class T>
  T read() {
    using Bits = std::conditional_t<
        sizeof(T) == 8, std::uint64_t,
        std::conditional_t<sizeof(T) == 4, std::uint32_t,
                           std::conditional_t<sizeof(T) == 2, std::uint16_t, std::uint8_t>>>;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      const std::size_t shift = 8 * (order_ == ByteOrder::little ? i : sizeof(T) - 1 - i);
      bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_[offset_ + i])) << shift;
    }
    offset_ += sizeof(T);
    return std::bit_cast<T>(static_cast<Bits>(bits));
  }

 private:
  std::string_view bytes_;
  std::size_t offset_;
  ByteOrder order_;
};

/// Appends a value's bytes, little endian on every machine.
template <class T>
void append_little_endian(std::string& out, T value) {
  unsigned char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T); ++i)
    out += static_cast<char>(bytes[std::endian::native == std::endian::little ? i : sizeof(T) - 1 - i]);
}

/// Collects the SPACE tag of a file; refuses an unknown tag and two tags that contradict each other.
class SpaceTag {
 public:
  void see(const Source& source, std::string_view text);
  std::optional<AnatomicalSpace> value() const { return value_; }

 private:
  std::optional<AnatomicalSpace> value_;
};

/// "LPS" or "RAS".
std::string_view name(AnatomicalSpace space);

/// Remedies that several readers name in their errors.
inline constexpr const char* remedy_export_again =
    "the file is damaged or was cut off: export or copy it again";
inline constexpr const char* remedy_triangulate =
    "triangulate the surface before reading it (e.g. MeshLab: Turn into a Pure Triangular Mesh)";
inline constexpr const char* remedy_other_format =
    "export the surface as a triangle mesh in PLY, STL, OBJ or OFF";

}  // namespace foramen::io_detail
