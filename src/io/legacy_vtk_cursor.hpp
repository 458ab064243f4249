#pragma once
/// \file
/// Private to io: the lines and numbers of a legacy VTK file, as text or big-endian binary.

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "io/file_bytes.hpp"

namespace foramen::io_detail {

inline constexpr const char* remedy_damaged =
    "the file is damaged, cut off or no VTK surface: export it again, best as PLY";

enum class VtkKind { integer, real };
struct VtkNumberType {
  std::string_view name;
  VtkKind kind;
  std::size_t bytes;
  bool is_signed;
};

// vtkIdType has 32 bits in such files, however VTK was built.
inline constexpr std::array<VtkNumberType, 16> vtk_number_types{
    {{"float", VtkKind::real, 4, true},
     {"double", VtkKind::real, 8, true},
     {"char", VtkKind::integer, 1, true},
     {"unsigned_char", VtkKind::integer, 1, false},
     {"short", VtkKind::integer, 2, true},
     {"unsigned_short", VtkKind::integer, 2, false},
     {"int", VtkKind::integer, 4, true},
     {"unsigned_int", VtkKind::integer, 4, false},
     {"long", VtkKind::integer, 8, true},
     {"unsigned_long", VtkKind::integer, 8, false},
     {"vtktypeint64", VtkKind::integer, 8, true},
     {"vtktypeuint64", VtkKind::integer, 8, false},
     {"vtkidtype", VtkKind::integer, 4, true},
     {"signed_char", VtkKind::integer, 1, true},
     {"long_long", VtkKind::integer, 8, true},
     {"unsigned_long_long", VtkKind::integer, 8, false}}};
inline constexpr VtkNumberType vtk_plain_int = vtk_number_types[6];

/// A cursor over a legacy VTK file. Its members throw IoError with the line for anything else than they
/// expect.
class LegacyVtkCursor {
 public:
  explicit LegacyVtkCursor(const Source& source) : source_(source) {}

 protected:
  [[noreturn]] void refuse(const std::string& found, const char* remedy = remedy_damaged) const {
    source_.refuse("line " + std::to_string(line_number_) + ": " + found, remedy);
  }
  std::size_t remaining() const { return source_.bytes.size() - offset_; }

  // In binary files only the lines outside the data are counted.
  bool next_line() {
    while (offset_ < source_.bytes.size()) {
      const auto end = std::min(source_.bytes.find('\n', offset_), source_.bytes.size());
      line_ = source_.bytes.substr(offset_, end - offset_);
      offset_ = std::min(end + 1, source_.bytes.size());
      ++line_number_;
      if (!TokenCursor(line_).rest().empty()) return true;
    }
    return false;
  }
  void need_line(const char* what) {
    if (!next_line()) source_.refuse(std::string("the file ends before ") + what, remedy_damaged);
  }

  std::uint64_t parse_count(std::string_view word) const {
    const auto count = to_integer(word);
    if (!count || *count < 0) refuse("expected a count, found " + in_quotes(word));
    return static_cast<std::uint64_t>(*count);
  }
  VtkNumberType parse_type(std::string_view word) const {
    const std::string lower = lower_case(word);
    for (const VtkNumberType& type : vtk_number_types)
      if (type.name == lower) return type;
    refuse("numbers of type " + in_quotes(word) + " are not read", remedy_other_format);
  }
  // Refuses a number of values that the rest of the file cannot hold, before memory is allocated. In a text
  // file each value takes at least a digit and a blank.
  void check_room(std::uint64_t count, const VtkNumberType& type, const std::string& what) const {
    const std::uint64_t each = binary_ ? type.bytes : 2, room = binary_ ? remaining() : remaining() + 1;
    if (count > room / each)
      refuse(what + " needs " + std::to_string(count) + " numbers, more than the " +
             std::to_string(remaining()) + " bytes that follow can hold");
  }

  // The next value. check_room() gives a lower bound only, so a text file may still end here.
  std::string_view next_token(const char* what) {
    constexpr std::string_view blanks = " \t\v\f\r\n";
    std::size_t begin = offset_;
    for (; begin < source_.bytes.size() && blanks.find(source_.bytes[begin]) != std::string_view::npos;
         ++begin)
      if (source_.bytes[begin] == '\n') ++line_number_;
    const std::size_t end = std::min(source_.bytes.find_first_of(blanks, begin), source_.bytes.size());
    offset_ = end;
    if (begin == end) source_.refuse(std::string("the file ends within ") + what, remedy_damaged);
    return source_.bytes.substr(begin, end - begin);
  }
  std::int64_t next_integer(const VtkNumberType& type, const char* what) {
    if (binary_) return binary_integer(type);
    const std::string_view token = next_token(what);
    const auto value = to_integer(token);
    if (!value) refuse("expected an integer in " + std::string(what) + ", found " + in_quotes(token));
    return *value;
  }
  double next_number(const VtkNumberType& type, const char* what) {
    if (binary_) {
      if (type.kind == VtkKind::integer) return static_cast<double>(binary_integer(type));
      return type.bytes == 4 ? static_cast<double>(next_bytes<float>()) : next_bytes<double>();
    }
    const std::string_view token = next_token(what);
    const auto value = to_number(token);
    if (!value) refuse("expected a number in " + std::string(what) + ", found " + in_quotes(token));
    return *value;
  }
  template <class T>
  T next_bytes() {
    ByteCursor bytes(source_.bytes, offset_, ByteOrder::big);
    offset_ += sizeof(T);
    return bytes.read<T>();
  }
  std::int64_t binary_integer(const VtkNumberType& type) {
    switch (type.bytes) {
      case 1:
        return type.is_signed ? next_bytes<std::int8_t>() : next_bytes<std::uint8_t>();
      case 2:
        return type.is_signed ? next_bytes<std::int16_t>() : next_bytes<std::uint16_t>();
      case 4:
        return type.is_signed ? next_bytes<std::int32_t>()
                              : static_cast<std::int64_t>(next_bytes<std::uint32_t>());
      default:
        return next_bytes<std::int64_t>();
    }
  }
  // In a text file the data begin on the line after their heading and must fill their last line to its end.
  void begin_data(std::uint64_t count) {
    if (!binary_ && count > 0) ++line_number_;
  }
  void end_data(std::uint64_t count) {
    if (binary_ || count == 0) return;
    const auto end = std::min(source_.bytes.find('\n', offset_), source_.bytes.size());
    const std::string_view rest = TokenCursor(source_.bytes.substr(offset_, end - offset_)).rest();
    if (!rest.empty()) refuse("more numbers than announced, from " + in_quotes(rest));
    offset_ = std::min(end + 1, source_.bytes.size());
  }
  void expect_line_end(TokenCursor words) const {
    if (!words.rest().empty()) refuse("unexpected " + in_quotes(words.rest()));
  }

  const Source& source_;
  bool binary_ = false;
  std::size_t offset_ = 0, line_number_ = 0;
  std::string_view line_;
};

}  // namespace foramen::io_detail
