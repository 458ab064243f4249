// Legacy VTK: PolyData, and unstructured grids whose cells are those of a surface. Not read by the VTK
// library, because VTK 9.1 crashes on a file that ends within its cells and returns uninitialised memory
// for points that are missing.
#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/legacy_vtk_cursor.hpp"
#include "io/mesh_formats.hpp"
#include "io/vtk_cells.hpp"

namespace foramen::io_detail {
namespace {

class LegacyVtk : LegacyVtkCursor {
 public:
  explicit LegacyVtk(const Source& source) : LegacyVtkCursor(source), soup_(source) {}

  MeshFile parse() {
    parse_sections();
    if (is_grid_) add_grid_cells();
    for (std::size_t f = 0; f + 1 < polygons_.offsets.size(); ++f)
      soup_.add_face(corners_of(polygons_, f, "face "), soup_.points(),
                     [&] { return "face " + std::to_string(f); });
    for (std::size_t s = 0; s + 1 < strips_.offsets.size(); ++s)
      soup_.add_strip(corners_of(strips_, s, "strip "), soup_.points(),
                      [&] { return "strip " + std::to_string(s); });
    return soup_.finish(space_.value());
  }

  /// The scalars of the points.
  std::vector<VertexScalar> scalars() {
    parse_sections();
    if (lower_case(TokenCursor(line_).next()) != "point_data") return {};
    return parse_point_data();
  }

 private:
  // The corners of cell f are corners[offsets[f]] .. corners[offsets[f + 1] - 1].
  struct Cells {
    std::vector<std::int64_t> offsets, corners;
  };

  // Stops at the fields on points or cells.
  void parse_sections() {
    parse_header();
    while (next_line()) {
      TokenCursor words(line_);
      const std::string keyword = lower_case(words.next());
      if (keyword == "point_data" || keyword == "cell_data") return;
      parse_section(keyword, words);
    }
  }

  std::vector<VertexScalar> parse_point_data() {
    const std::uint64_t points = soup_.points();
    std::vector<VertexScalar> scalars;
    while (next_line()) {
      TokenCursor words(line_);
      const std::string keyword = lower_case(words.next());
      if (keyword == "cell_data") break;
      if (keyword == "metadata") {
        skip_metadata();
      } else if (keyword == "field") {
        for (VertexScalar& array : read_field(words)) keep(std::move(array), scalars);
      } else if (keyword == "scalars") {
        const std::string name(words.next());
        const VtkNumberType type = parse_type(words.next());
        const std::string_view components = words.next();
        need_line("LOOKUP_TABLE");
        if (lower_case(TokenCursor(line_).next()) != "lookup_table")
          refuse("expected LOOKUP_TABLE, found " + in_quotes(line_));
        keep({name, numbers(points * (components.empty() ? 1 : parse_count(components)), type, "POINT_DATA")},
             scalars);
      } else if (keyword == "normals" || keyword == "vectors") {
        words.next();  // its name
        numbers(3 * points, parse_type(words.next()), "POINT_DATA");
      } else if (keyword == "texture_coordinates") {
        words.next();
        const std::uint64_t components = parse_count(words.next());
        numbers(components * points, parse_type(words.next()), "POINT_DATA");
      } else {
        refuse("unknown field " + in_quotes(line_) + " on points", "save the labels alone, or as text");
      }
    }
    return scalars;
  }
  // Keeps a field of one number a point.
  void keep(VertexScalar field, std::vector<VertexScalar>& scalars) const {
    if (field.values.size() == soup_.points()) scalars.push_back(std::move(field));
  }
  std::vector<double> numbers(std::uint64_t count, const VtkNumberType& type, const char* what) {
    check_room(count, type, what);
    begin_data(count);
    std::vector<double> values;
    values.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i) values.push_back(next_number(type, what));
    end_data(count);
    return values;
  }

  void parse_header() {
    constexpr std::string_view magic = "# vtk DataFile Version";
    offset_ = byte_order_mark(source_.bytes);
    if (!next_line() || !line_.starts_with(magic))
      source_.refuse("does not begin with '# vtk DataFile Version'",
                     "it is no VTK file: check its format and extension");
    const auto version = to_number(TokenCursor(line_.substr(magic.size())).rest());
    if (!version) refuse("unknown version in " + in_quotes(line_));
    constexpr double first_with_offsets = 5;
    has_offsets_ = *version >= first_with_offsets;
    // The title may be blank.
    const auto title_end = std::min(source_.bytes.find('\n', offset_), source_.bytes.size());
    space_.see(source_, source_.bytes.substr(offset_, title_end - offset_));
    offset_ = std::min(title_end + 1, source_.bytes.size());
    ++line_number_;
    need_line("ASCII or BINARY");
    const std::string encoding = lower_case(TokenCursor(line_).rest());
    if (encoding != "ascii" && encoding != "binary")
      refuse("expected ASCII or BINARY, found " + in_quotes(line_));
    binary_ = encoding == "binary";
    need_line("DATASET");
    TokenCursor words(line_);
    const bool is_dataset = lower_case(words.next()) == "dataset";
    const std::string kind = lower_case(words.next());
    is_grid_ = kind == "unstructured_grid";
    if (!is_dataset || (kind != "polydata" && !is_grid_))
      refuse("expected 'DATASET POLYDATA', found " + in_quotes(line_),
             "foramen reads surfaces, no images or grids: export the surface");
  }

  void parse_section(const std::string& keyword, TokenCursor words) {
    if (keyword == "points")
      parse_points(words);
    else if (keyword == "cells" && is_grid_)
      read_cells(words, grid_cells_, "CELLS");
    else if (keyword == "cell_types" && is_grid_)
      parse_cell_types(words);
    else if (keyword == "polygons")
      read_cells(words, polygons_, "POLYGONS");
    else if (keyword == "triangle_strips")
      read_cells(words, strips_, "TRIANGLE_STRIPS");
    else if (keyword == "vertices" || keyword == "lines")
      pass_over_cells(words, keyword);
    else if (keyword == "field")
      read_field(words);
    else if (keyword == "metadata")
      skip_metadata();
    else
      refuse("unknown section " + in_quotes(line_));
  }

  void parse_points(TokenCursor words) {
    if (soup_.points() > 0) refuse("a second POINTS section");
    const std::uint64_t count = parse_count(words.next());
    const VtkNumberType type = parse_type(words.next());
    expect_line_end(words);
    check_room(count, vtk_number_types[2],
               "POINTS");  // each value takes at least a byte, so the product with 3 does not overflow
    check_room(3 * count, type, "POINTS");
    soup_.expect(count, 0, remaining(), 0, 0);
    begin_data(count);
    for (std::uint64_t v = 0; v < count; ++v) {
      Vec3 point;
      for (int k = 0; k < 3; ++k) point[k] = next_number(type, "POINTS");
      soup_.add_point(point, [&] { return "vertex " + std::to_string(v); });
    }
    end_data(count);
  }

  void pass_over_cells(TokenCursor words, const std::string& keyword) {
    Cells cells;
    read_cells(words, cells, keyword == "lines" ? "LINES" : "VERTICES");
    if (!cells.offsets.empty()) soup_.pass_over_loose(cells.offsets.size() - 1);
  }

  void read_cells(TokenCursor words, Cells& cells, const char* what) {
    if (!cells.offsets.empty()) refuse("a second " + std::string(what) + " section");
    const std::uint64_t count = parse_count(words.next()), size = parse_count(words.next());
    expect_line_end(words);
    if (has_offsets_) {
      if (count == 0 && size == 0) return;
      cells.offsets = parse_indices("OFFSETS", count);
      cells.corners = parse_indices("CONNECTIVITY", size);
    } else {
      parse_counted_cells(count, size, cells, what);
    }
  }

  void parse_cell_types(TokenCursor words) {
    if (!grid_types_.empty()) refuse("a second CELL_TYPES section");
    const std::uint64_t count = parse_count(words.next());
    expect_line_end(words);
    check_room(count, vtk_plain_int, "CELL_TYPES");
    begin_data(count);
    for (std::uint64_t c = 0; c < count; ++c)
      grid_types_.push_back(next_integer(vtk_plain_int, "CELL_TYPES"));
    end_data(count);
  }

  // The points of a grid often serve other cells that were taken out of it.
  void add_grid_cells() {
    soup_.pass_over_unused_points();
    const std::size_t count = grid_cells_.offsets.empty() ? 0 : grid_cells_.offsets.size() - 1;
    if (grid_types_.size() != count)
      source_.refuse(
          "has " + std::to_string(count) + " CELLS and " + std::to_string(grid_types_.size()) + " CELL_TYPES",
          remedy_damaged);
    for (std::size_t c = 0; c < count; ++c)
      add_vtk_cell(soup_, source_, grid_types_[c], corners_of(grid_cells_, c, "cell "), c);
  }

  // The layout before version 5: for each cell the number of its corners and then its corners.
  void parse_counted_cells(std::uint64_t count, std::uint64_t size, Cells& cells, const char* what) {
    check_room(size, vtk_plain_int, what);
    if (count > size)
      refuse("announces " + std::to_string(count) + " cells of " + std::to_string(size) + " numbers");
    begin_data(size);
    cells.offsets.push_back(0);
    for (std::uint64_t f = 0, used = 0; f < count; ++f) {
      const std::int64_t length = used < size ? next_integer(vtk_plain_int, what) : -1;
      if (length < 0 || static_cast<std::uint64_t>(length) >= size - used)
        refuse("face " + std::to_string(f) + " of " + what + " does not fit its announced size");
      for (std::int64_t k = 0; k < length; ++k) cells.corners.push_back(next_integer(vtk_plain_int, what));
      used += static_cast<std::uint64_t>(length) + 1;
      cells.offsets.push_back(static_cast<std::int64_t>(cells.corners.size()));
      if (f + 1 == count && used != size) refuse(std::string(what) + " has other than its announced size");
    }
    end_data(size);
  }

  std::vector<std::int64_t> parse_indices(const char* keyword, std::uint64_t count) {
    need_line(keyword);
    TokenCursor words(line_);
    if (lower_case(words.next()) != lower_case(keyword))
      refuse(std::string("expected ") + keyword + ", found " + in_quotes(line_));
    const VtkNumberType type = parse_type(words.next());
    expect_line_end(words);
    if (type.kind != VtkKind::integer) refuse(std::string(keyword) + " must be integers");
    check_room(count, type, keyword);
    begin_data(count);
    std::vector<std::int64_t> values;
    values.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i) values.push_back(next_integer(type, keyword));
    end_data(count);
    return values;
  }

  std::span<const std::int64_t> corners_of(const Cells& cells, std::size_t f, const char* what) const {
    const std::int64_t begin = cells.offsets[f], end = cells.offsets[f + 1];
    if (begin < 0 || end < begin || end > std::ssize(cells.corners))
      source_.refuse(what + std::to_string(f) + ": its offsets " + std::to_string(begin) + " and " +
                         std::to_string(end) + " are out of order or range",
                     remedy_damaged);
    return std::span(cells.corners).subspan(begin, end - begin);
  }

  // The arrays of numbers.
  std::vector<VertexScalar> read_field(TokenCursor words) {
    words.next();  // its name
    const std::uint64_t arrays = parse_count(words.next());
    std::vector<VertexScalar> read;
    for (std::uint64_t a = 0; a < arrays; ++a) {
      need_line("an array of FIELD");
      if (lower_case(TokenCursor(line_).next()) == "metadata") {  // of the array before
        skip_metadata();
        need_line("an array of FIELD");
      }
      read.push_back(read_array(TokenCursor(line_)));
    }
    return read;
  }

  // Without values if the array holds no numbers.
  VertexScalar read_array(TokenCursor heading) {
    const std::string name(heading.next());
    if (lower_case(name) == "null_array") return {name, {}};
    const std::uint64_t components = parse_count(heading.next()), tuples = parse_count(heading.next());
    const std::string type = lower_case(heading.next());
    const std::uint64_t room = 8 * (remaining() + 1);  // a value takes at least a bit
    if (components > room || (components > 0 && tuples > room / components))
      refuse("FIELD needs more numbers than the " + std::to_string(remaining()) +
             " bytes that follow can hold");
    const std::uint64_t count = components * tuples;
    if (type == "string" || type == "utf8_string") {
      for (std::uint64_t i = 0; i < count; ++i) skip_string(name);
      return {name, {}};
    }
    if (type == "bit" && binary_) {
      check_room((count + 7) / 8, vtk_number_types[2], "FIELD");
      offset_ += (count + 7) / 8;
      return {name, {}};
    }
    return {name, numbers(count, type == "bit" ? vtk_number_types[2] : parse_type(type), "FIELD")};
  }

  // A line of a text file. In a binary file the first two bits say how many bytes hold the length: 3, 2, 1, 0
  // for 1, 2, 4, 8 of them.
  void skip_string(std::string_view name) {
    std::size_t length = 0;
    if (binary_) {
      if (remaining() == 0) source_.refuse("the file ends within FIELD", remedy_damaged);
      const auto first = static_cast<unsigned char>(source_.bytes[offset_]);
      const std::size_t bytes = std::size_t{8} >> (first >> 6U);
      if (bytes > remaining()) source_.refuse("the file ends within FIELD", remedy_damaged);
      std::uint64_t written = first & 63U;
      for (std::size_t i = 1; i < bytes; ++i)
        written = written << 8U | static_cast<unsigned char>(source_.bytes[offset_ + i]);
      offset_ += bytes;
      if (written > remaining()) source_.refuse("the file ends within FIELD", remedy_damaged);
      length = written;
    } else {
      if (remaining() == 0) source_.refuse("the file ends within FIELD", remedy_damaged);
      length = std::min(source_.bytes.find('\n', offset_), source_.bytes.size()) - offset_;
      ++line_number_;
    }
    if (name == "SPACE") space_.see(source_, "SPACE=" + std::string(source_.bytes.substr(offset_, length)));
    offset_ = std::min(offset_ + length + (binary_ ? 0 : 1), source_.bytes.size());
  }

  // Skips a METADATA section, which ends with a blank line.
  void skip_metadata() {
    while (offset_ < source_.bytes.size()) {
      const auto end = std::min(source_.bytes.find('\n', offset_), source_.bytes.size());
      const bool blank = TokenCursor(source_.bytes.substr(offset_, end - offset_)).rest().empty();
      offset_ = std::min(end + 1, source_.bytes.size());
      ++line_number_;
      if (blank) return;
    }
  }

  SoupBuilder soup_;
  SpaceTag space_;
  bool has_offsets_ = false, is_grid_ = false;
  Cells polygons_, strips_, grid_cells_;
  std::vector<std::int64_t> grid_types_;
};

}  // namespace

MeshFile parse_vtk(const Source& source) { return LegacyVtk(source).parse(); }

std::vector<VertexScalar> parse_vtk_scalars(const Source& source) { return LegacyVtk(source).scalars(); }

}  // namespace foramen::io_detail
