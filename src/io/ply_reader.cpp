#include <array>
#include <limits>

#include "io/mesh_formats.hpp"
#include "io/ply_header.hpp"

namespace foramen::io_detail {
namespace {

// The elements and properties of a PLY file that make up the surface.
struct Layout {
  std::size_t vertex_element = 0, face_element = 0;
  std::array<std::size_t, 3> coordinates{};  // properties of the vertex element
  std::size_t corners = 0;                   // property of the face element
};

std::size_t find_element(const Source& source, const PlyHeader& header, const std::string& name) {
  for (std::size_t i = 0; i < header.elements.size(); ++i)
    if (header.elements[i].name == name) return i;
  source.refuse("its header declares no element '" + name + "'",
                name == "face" ? "it is a point cloud or holds strips: export the surface as triangles"
                               : "export the surface again");
}

Layout find_layout(const Source& source, const PlyHeader& header) {
  Layout layout;
  layout.vertex_element = find_element(source, header, "vertex");
  layout.face_element = find_element(source, header, "face");
  const auto& vertex = header.elements[layout.vertex_element].properties;
  constexpr std::array<const char*, 3> axes{"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t i = 0;
    while (i < vertex.size() && (vertex[i].name != axes[k] || vertex[i].count_type)) ++i;
    if (i == vertex.size())
      source.refuse(std::string("its vertices have no number '") + axes[k] + "'", "export the surface again");
    layout.coordinates[k] = i;
  }
  const auto& face = header.elements[layout.face_element].properties;
  std::size_t lists = 0;
  for (std::size_t i = 0; i < face.size(); ++i)
    if (face[i].name == "vertex_indices" || face[i].name == "vertex_index") {
      layout.corners = i;
      ++lists;
    }
  if (lists != 1 || !face[layout.corners].count_type || !is_integer(face[layout.corners].type))
    source.refuse("its faces have no single list 'vertex_indices' (or 'vertex_index') of integers",
                  "export the surface again as triangles");
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
  void end_body() {
    if (lines_.next_filled())
      source_.refuse(place() + ": data after the last element, " + in_quotes(lines_.line()),
                     remedy_export_again);
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
  void end_body() {
    if (bytes_.remaining() > 0)
      source_.refuse(std::to_string(bytes_.remaining()) +
                         " bytes of data after the last element, from byte " +
                         std::to_string(bytes_.offset()),
                     remedy_export_again);
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
void read_face(const Source& source, Rows& rows, const PlyElement& element, const Layout& layout,
               std::uint64_t vertex_count, SoupBuilder& soup) {
  std::array<std::int64_t, 3> corners{};
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    if (i != layout.corners) {
      skip_property(source, rows, property);
      continue;
    }
    const std::int64_t length = list_length(source, rows, property);
    if (length != 3) refuse_polygon(source, rows.place(), static_cast<std::uint64_t>(length));
    for (std::int64_t& corner : corners) corner = rows.integer(property.type);
  }
  soup.add_triangle(corners, vertex_count, [&] { return rows.place(); });
}

template <class Rows>
TriangleSoup read_body(const Source& source, const PlyHeader& header, Rows rows) {
  const Layout layout = find_layout(source, header);
  check_size(source, header, rows);
  SoupBuilder soup(source);
  const PlyElement& vertex = header.elements[layout.vertex_element];
  const PlyElement& face = header.elements[layout.face_element];
  soup.expect(vertex.count, face.count, rows.remaining(), Rows::least_bytes(vertex), Rows::least_bytes(face));
  for (std::size_t e = 0; e < header.elements.size(); ++e) {
    const PlyElement& element = header.elements[e];
    for (std::uint64_t row = 0; row < element.count; ++row) {
      rows.begin_row(element, row);
      if (e == layout.vertex_element)
        read_vertex(source, rows, element, layout, soup);
      else if (e == layout.face_element)
        read_face(source, rows, element, layout, vertex.count, soup);
      else
        for (const PlyProperty& property : element.properties) skip_property(source, rows, property);
      rows.end_row();
    }
  }
  rows.end_body();
  return soup.take();
}

}  // namespace

MeshFile parse_ply(const Source& source) {
  LineCursor lines(source.bytes);
  const PlyHeader header = parse_ply_header(source, lines);
  if (header.encoding == PlyEncoding::ascii)
    return {read_body(source, header, TextRows(source, lines)), header.space};
  const ByteOrder order =
      header.encoding == PlyEncoding::binary_little_endian ? ByteOrder::little : ByteOrder::big;
  return {read_body(source, header, BinaryRows(source, lines.offset(), order)), header.space};
}

}  // namespace foramen::io_detail
