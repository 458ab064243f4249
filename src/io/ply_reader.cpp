#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "io/mesh_formats.hpp"
#include "io/ply_header.hpp"

namespace foramen::io_detail {
namespace {

// An element of lists of corners: faces, or strips in which -1 begins a new strip.
struct CornerLists {
  std::size_t element = 0, property = 0;
  bool strips = false;
};

// The elements and properties of a PLY file that make up the surface.
struct Layout {
  std::size_t vertex_element = 0;
  std::array<std::size_t, 3> coordinates{};  // properties of the vertex element
  std::vector<CornerLists> surface;
  const CornerLists* lists_of(std::size_t element) const {
    for (const CornerLists& lists : surface)
      if (lists.element == element) return &lists;
    return nullptr;
  }
};

std::optional<std::size_t> find_element(const PlyHeader& header, const std::string& name) {
  for (std::size_t i = 0; i < header.elements.size(); ++i)
    if (header.elements[i].name == name) return i;
  return std::nullopt;
}

std::size_t find_corners(const Source& source, const PlyElement& element) {
  std::size_t corners = 0, lists = 0;
  for (std::size_t i = 0; i < element.properties.size(); ++i)
    if (element.properties[i].name == "vertex_indices" || element.properties[i].name == "vertex_index") {
      corners = i;
      ++lists;
    }
  if (lists != 1 || !element.properties[corners].count_type || !is_integer(element.properties[corners].type))
    source.refuse("its faces have no single list 'vertex_indices' (or 'vertex_index') of integers",
                  "export the surface again as triangles");
  return corners;
}

Layout find_layout(const Source& source, const PlyHeader& header) {
  Layout layout;
  const auto vertices = find_element(header, "vertex");
  if (!vertices) source.refuse("its header declares no element 'vertex'", "export the surface again");
  layout.vertex_element = *vertices;
  const auto& vertex = header.elements[layout.vertex_element].properties;
  constexpr std::array<const char*, 3> axes{"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t i = 0;
    while (i < vertex.size() && (vertex[i].name != axes[k] || vertex[i].count_type)) ++i;
    if (i == vertex.size())
      source.refuse(std::string("its vertices have no number '") + axes[k] + "'", "export the surface again");
    layout.coordinates[k] = i;
  }
  for (const auto& [name, strips] : {std::pair("face", false), std::pair("tristrips", true)})
    if (const auto element = find_element(header, name))
      layout.surface.push_back({*element, find_corners(source, header.elements[*element]), strips});
  if (layout.surface.empty())
    source.refuse("its header declares no element 'face'",
                  "it is a point cloud: export the surface as triangles");
  return layout;
}

// A reader of the rows of a text body, one row per line.
class TextRows {
 public:
  TextRows(const Source& source, LineCursor lines) : source_(source), lines_(lines) {}
  static std::uint64_t least_bytes(const PlyElement& element) {
    return 2 * element.properties.size();  // a digit and a blank or a line end for each value
  }
  std::uint64_t remaining() const { return lines_.remaining() + 1; }  // the last line end may be absent
  void begin_row(const PlyElement& element, std::uint64_t row) {
    if (!lines_.next_filled())
      source_.refuse("the file ends before " + element.name + " " + std::to_string(row) + " of " +
                         std::to_string(element.count),
                     remedy_export_again);
    tokens_ = TokenCursor(lines_.line());
  }
  void end_row() {
    if (!tokens_.rest().empty())
      source_.refuse(place() + ": more values than its element declares, from " + in_quotes(tokens_.rest()),
                     remedy_export_again);
  }
  double number(PlyScalar) { return parse(to_number(tokens_.next()), "a number"); }
  std::int64_t integer(PlyScalar) { return parse(to_integer(tokens_.next()), "an integer"); }
  std::string place() const { return lines_.place(); }
  /// The number of bytes after the last element, without blank lines.
  std::uint64_t trailing() {
    std::uint64_t bytes = 0;
    while (lines_.next_filled()) bytes += lines_.line().size();
    return bytes;
  }

 private:
  template <class T>
  T parse(const std::optional<T>& value, const char* what) const {
    if (!value)
      source_.refuse(place() + ": expected " + what + " in " + in_quotes(lines_.line()), remedy_export_again);
    return *value;
  }
  const Source& source_;
  LineCursor lines_;
  TokenCursor tokens_{std::string_view()};
};

class BinaryRows {
 public:
  BinaryRows(const Source& source, std::size_t offset, ByteOrder order)
      : source_(source), bytes_(source.bytes, offset, order) {}
  static std::uint64_t least_bytes(const PlyElement& element) {
    std::uint64_t sum = 0;
    for (const PlyProperty& p : element.properties) sum += byte_size(p.count_type.value_or(p.type));
    return sum;
  }
  std::uint64_t remaining() const { return bytes_.remaining(); }
  void begin_row(const PlyElement& element, std::uint64_t row) {
    element_ = &element.name;
    row_ = row;
  }
  void end_row() {}
  double number(PlyScalar type) {
    need(type);
    if (type == PlyScalar::f32) return static_cast<double>(bytes_.read<float>());
    if (type == PlyScalar::f64) return bytes_.read<double>();
    return static_cast<double>(read_integer(type));
  }
  std::int64_t integer(PlyScalar type) {
    need(type);
    return read_integer(type);
  }
  std::string place() const { return *element_ + " " + std::to_string(row_); }
  /// The number of bytes after the last element, without line ends.
  std::uint64_t trailing() const {
    const std::string_view rest = source_.bytes.substr(bytes_.offset());
    return rest.find_first_not_of("\r\n") == std::string_view::npos ? 0 : rest.size();
  }

 private:
  void need(PlyScalar type) const {
    if (bytes_.remaining() < byte_size(type))
      source_.refuse("the file ends at byte " + std::to_string(source_.bytes.size()) + ", within " + place(),
                     remedy_export_again);
  }
  std::int64_t read_integer(PlyScalar type) {
    switch (type) {
      case PlyScalar::i8:
        return bytes_.read<std::int8_t>();
      case PlyScalar::u8:
        return bytes_.read<std::uint8_t>();
      case PlyScalar::i16:
        return bytes_.read<std::int16_t>();
      case PlyScalar::u16:
        return bytes_.read<std::uint16_t>();
      case PlyScalar::i32:
        return bytes_.read<std::int32_t>();
      default:
        return bytes_.read<std::uint32_t>();
    }
  }
  const Source& source_;
  ByteCursor bytes_;
  const std::string* element_ = nullptr;
  std::uint64_t row_ = 0;
};

// Refuses a header whose elements cannot fit in the data after it, before memory is allocated for them.
template <class Rows>
void check_size(const Source& source, const PlyHeader& header, const Rows& rows) {
  std::uint64_t left = rows.remaining();
  for (const PlyElement& element : header.elements) {
    if (element.count == 0) continue;
    const std::uint64_t row = Rows::least_bytes(element);
    if (row == 0)
      source.refuse("its element '" + element.name + "' has no properties", "export the surface again");
    if (element.count > left / row)
      source.refuse("its header announces " + std::to_string(element.count) + " x '" + element.name +
                        "' of at least " + std::to_string(row) + " bytes, but only " + std::to_string(left) +
                        " bytes are left for them",
                    remedy_export_again);
    left -= element.count * row;
  }
}

template <class Rows>
std::int64_t list_length(const Source& source, Rows& rows, const PlyProperty& list) {
  const std::int64_t length = rows.integer(*list.count_type);
  if (length < 0)
    source.refuse(rows.place() + ": a list of length " + std::to_string(length), remedy_export_again);
  return length;
}

template <class Rows>
void skip_property(const Source& source, Rows& rows, const PlyProperty& property) {
  const std::int64_t count = property.count_type ? list_length(source, rows, property) : 1;
  for (std::int64_t i = 0; i < count; ++i) rows.number(property.type);
}

template <class Rows>
void read_vertex(const Source& source, Rows& rows, const PlyElement& element, const Layout& layout,
                 SoupBuilder& soup) {
  Vec3 point = Vec3::Zero();
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    bool coordinate = false;
    for (std::size_t k = 0; k < 3; ++k)
      if (layout.coordinates[k] == i) {
        point[static_cast<int>(k)] = rows.number(property.type);
        coordinate = true;
      }
    if (!coordinate) skip_property(source, rows, property);
  }
  soup.add_point(point, [&] { return rows.place(); });
}

template <class Rows>
void read_face(const Source& source, Rows& rows, const PlyElement& element, const CornerLists& lists,
               std::uint64_t vertex_count, std::vector<std::int64_t>& corners, SoupBuilder& soup) {
  corners.clear();
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    if (i != lists.property) {
      skip_property(source, rows, property);
      continue;
    }
    const std::int64_t length = list_length(source, rows, property);
    for (std::int64_t k = 0; k < length; ++k) corners.push_back(rows.integer(property.type));
  }
  const auto place = [&] { return rows.place(); };
  if (!lists.strips) return soup.add_face(corners, vertex_count, place);
  for (auto begin = corners.begin(); begin != corners.end();) {
    const auto end = std::find(begin, corners.end(), -1);
    soup.add_strip({begin, end}, vertex_count, place);
    begin = end == corners.end() ? end : end + 1;
  }
}

template <class Rows>
MeshFile read_body(const Source& source, const PlyHeader& header, Rows rows) {
  const Layout layout = find_layout(source, header);
  check_size(source, header, rows);
  SoupBuilder soup(source);
  const PlyElement& vertex = header.elements[layout.vertex_element];
  const PlyElement& face = header.elements[layout.surface.front().element];
  soup.expect(vertex.count, face.count, rows.remaining(), Rows::least_bytes(vertex), Rows::least_bytes(face));
  std::vector<std::int64_t> corners;
  for (std::size_t e = 0; e < header.elements.size(); ++e) {
    const PlyElement& element = header.elements[e];
    const CornerLists* lists = layout.lists_of(e);
    for (std::uint64_t row = 0; row < element.count; ++row) {
      rows.begin_row(element, row);
      if (e == layout.vertex_element)
        read_vertex(source, rows, element, layout, soup);
      else if (lists != nullptr)
        read_face(source, rows, element, *lists, vertex.count, corners, soup);
      else
        for (const PlyProperty& property : element.properties) skip_property(source, rows, property);
      rows.end_row();
    }
  }
  soup.pass_over_trailing(rows.trailing());
  return soup.finish(header.space);
}

template <class Rows>
std::vector<VertexScalar> read_scalars(const Source& source, const PlyHeader& header, Rows rows) {
  const Layout layout = find_layout(source, header);
  check_size(source, header, rows);
  std::vector<VertexScalar> of_property;
  for (std::size_t e = 0; e <= layout.vertex_element; ++e) {
    const PlyElement& element = header.elements[e];
    of_property.assign(element.properties.size(), {});
    for (std::uint64_t row = 0; row < element.count; ++row) {
      rows.begin_row(element, row);
      for (std::size_t i = 0; i < element.properties.size(); ++i)
        if (element.properties[i].count_type)
          skip_property(source, rows, element.properties[i]);
        else
          of_property[i].values.push_back(rows.number(element.properties[i].type));
      rows.end_row();
    }
  }
  std::vector<VertexScalar> scalars;
  for (std::size_t i = 0; i < of_property.size(); ++i) {
    const PlyProperty& property = header.elements[layout.vertex_element].properties[i];
    const bool coordinate =
        std::find(layout.coordinates.begin(), layout.coordinates.end(), i) != layout.coordinates.end();
    if (!coordinate && !property.count_type)
      scalars.push_back({property.name, std::move(of_property[i].values)});
  }
  return scalars;
}

// Calls read(header, rows) with the rows of the file's encoding.
template <class Read>
auto with_rows(const Source& source, const Read& read) {
  LineCursor lines(source.bytes);
  const PlyHeader header = parse_ply_header(source, lines);
  if (header.encoding == PlyEncoding::ascii) return read(header, TextRows(source, lines));
  const ByteOrder order =
      header.encoding == PlyEncoding::binary_little_endian ? ByteOrder::little : ByteOrder::big;
  return read(header, BinaryRows(source, lines.offset(), order));
}

}  // namespace

MeshFile parse_ply(const Source& source) {
  return with_rows(
      source, [&](const PlyHeader& header, auto rows) { return read_body(source, header, std::move(rows)); });
}

std::vector<VertexScalar> parse_ply_scalars(const Source& source) {
  return with_rows(source, [&](const PlyHeader& header, auto rows) {
    return read_scalars(source, header, std::move(rows));
  });
}

}  // namespace foramen::io_detail
