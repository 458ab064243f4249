#include "io/ply_header.hpp"

#include <algorithm>
#include <array>

namespace foramen::io_detail {
namespace {

struct TypeName {
  std::string_view name;
  PlyScalar type;
};

constexpr std::array<TypeName, 16> type_names{{{"char", PlyScalar::i8},
                                               {"int8", PlyScalar::i8},
                                               {"uchar", PlyScalar::u8},
                                               {"uint8", PlyScalar::u8},
                                               {"short", PlyScalar::i16},
                                               {"int16", PlyScalar::i16},
                                               {"ushort", PlyScalar::u16},
                                               {"uint16", PlyScalar::u16},
                                               {"int", PlyScalar::i32},
                                               {"int32", PlyScalar::i32},
                                               {"uint", PlyScalar::u32},
                                               {"uint32", PlyScalar::u32},
                                               {"float", PlyScalar::f32},
                                               {"float32", PlyScalar::f32},
                                               {"double", PlyScalar::f64},
                                               {"float64", PlyScalar::f64}}};

bool is_comment(std::string_view keyword) { return keyword == "comment" || keyword == "obj_info"; }

constexpr const char* remedy_header = "its PLY header is not valid: export the surface again";

class HeaderParser {
 public:
  HeaderParser(const Source& source, LineCursor& lines) : source_(source), lines_(lines) {}

  PlyHeader parse() {
    if (!lines_.next() || TokenCursor(lines_.line()).rest() != "ply")
      source_.refuse("does not begin with the line 'ply'",
                     "it is no PLY file: check its format and extension");
    parse_format();
    while (lines_.next()) {
      TokenCursor words(lines_.line());
      const std::string_view keyword = words.next();
      if (keyword == "end_header") {
        header_.space = space_.value();
        return std::move(header_);
      }
      parse_line(keyword, words);
    }
    source_.refuse("its header has no 'end_header' line", remedy_export_again);
  }

 private:
  [[noreturn]] void refuse(const std::string& found) const {
    source_.refuse(lines_.place() + ": " + found, remedy_header);
  }

  void parse_format() {
    TokenCursor words{std::string_view()};
    std::string_view keyword;
    do {
      if (!lines_.next()) refuse("the header ends before 'format'");
      words = TokenCursor(lines_.line());
      keyword = words.next();
      if (is_comment(keyword)) space_.see(source_, lines_.line());
    } while (keyword.empty() || is_comment(keyword));
    const std::string_view encoding = words.next(), version = words.next();
    if (keyword != "format") refuse("expected 'format', found " + in_quotes(lines_.line()));
    if (encoding == "ascii")
      header_.encoding = PlyEncoding::ascii;
    else if (encoding == "binary_little_endian")
      header_.encoding = PlyEncoding::binary_little_endian;
    else if (encoding == "binary_big_endian")
      header_.encoding = PlyEncoding::binary_big_endian;
    else
      refuse("unknown format " + in_quotes(encoding));
    if (version != "1.0" || !words.rest().empty()) refuse("unknown PLY version " + in_quotes(version));
  }

  void parse_line(std::string_view keyword, TokenCursor& words) {
    if (keyword.empty()) return;
    if (is_comment(keyword))
      space_.see(source_, lines_.line());
    else if (keyword == "element")
      parse_element(words);
    else if (keyword == "property")
      parse_property(words);
    else
      refuse("unknown header line " + in_quotes(lines_.line()));
  }

  void parse_element(TokenCursor& words) {
    PlyElement element;
    element.name = words.next();
    const std::string_view written = words.next();
    const auto count = to_integer(written);
    if (element.name.empty() || !count || *count < 0 || !words.rest().empty())
      refuse("expected 'element NAME COUNT', found " + in_quotes(lines_.line()));
    for (const PlyElement& other : header_.elements)
      if (other.name == element.name) refuse("element " + in_quotes(element.name) + " is declared twice");
    element.count = static_cast<std::uint64_t>(*count);
    header_.elements.push_back(std::move(element));
  }

  PlyScalar parse_type(std::string_view word) const {
    const auto found =
        std::find_if(type_names.begin(), type_names.end(), [&](const TypeName& t) { return t.name == word; });
    if (found == type_names.end()) refuse("unknown type " + in_quotes(word));
    return found->type;
  }

  void parse_property(TokenCursor& words) {
    if (header_.elements.empty()) refuse("a property before any element");
    PlyProperty property;
    std::string_view word = words.next();
    if (word == "list") {
      property.count_type = parse_type(words.next());
      if (!is_integer(*property.count_type)) refuse("a list whose length is no integer");
      word = words.next();
    }
    property.type = parse_type(word);
    property.name = words.next();
    if (property.name.empty() || !words.rest().empty())
      refuse("expected a property, found " + in_quotes(lines_.line()));
    auto& properties = header_.elements.back().properties;
    for (const PlyProperty& other : properties)
      if (other.name == property.name) refuse("property " + in_quotes(property.name) + " is declared twice");
    properties.push_back(std::move(property));
  }

  const Source& source_;
  LineCursor& lines_;
  PlyHeader header_;
  SpaceTag space_;
};

}  // namespace

std::size_t byte_size(PlyScalar type) {
  switch (type) {
    case PlyScalar::i8:
    case PlyScalar::u8:
      return 1;
    case PlyScalar::i16:
    case PlyScalar::u16:
      return 2;
    case PlyScalar::i32:
    case PlyScalar::u32:
    case PlyScalar::f32:
      return 4;
    case PlyScalar::f64:
      return 8;
  }
  return 8;
}

PlyHeader parse_ply_header(const Source& source, LineCursor& lines) {
  return HeaderParser(source, lines).parse();
}

}  // namespace foramen::io_detail
