#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "io/mesh_formats.hpp"
#include "io/vtk_data_array.hpp"

namespace foramen::io_detail {
namespace {

// A VTP file split into its XML document and the appended data, which may be raw bytes and thus not XML.
struct VtpFile {
  XmlElement root;
  std::string_view appended;
  bool appended_base64 = false;
};

VtpFile split(const Source& source) {
  const std::string_view bytes = source.bytes;
  if (bytes.find("<VTKFile") == std::string_view::npos)
    source.refuse("has no <VTKFile> element", "it is no VTK XML file: check its format and extension");
  constexpr std::string_view end_tag = "</VTKFile>";
  const auto last = bytes.find_last_not_of(" \t\r\n");
  if (!bytes.substr(0, last + 1).ends_with(end_tag))
    source.refuse("does not end with </VTKFile>", remedy_export_again);
  VtpFile file;
  const auto appended = bytes.find("<AppendedData");
  const auto close = appended == std::string_view::npos ? appended : bytes.find('>', appended);
  if (close == std::string_view::npos) {
    file.root = parse_xml(source, bytes);
    return file;
  }
  file.root = parse_xml(source, std::string(bytes.substr(0, close + 1)) + "</AppendedData></VTKFile>");
  const auto mark = bytes.find('_', close);
  file.appended = bytes.substr(std::min(mark, bytes.size() - 1) + 1);
  const XmlElement* element = file.root.child("AppendedData");
  file.appended_base64 = element != nullptr && element->attribute("encoding") == "base64";
  if (file.appended_base64) file.appended = file.appended.substr(0, file.appended.find('<'));
  return file;
}

class SurfaceReader {
 public:
  SurfaceReader(const Source& source, const VtpFile& file)
      : source_(source), arrays_(source, file.root, file.appended, file.appended_base64), soup_(source) {}

  MeshFile read(const XmlElement& root) {
    const XmlElement& data = poly_data(root);
    for (const XmlElement& piece : data.children)
      if (piece.name == "Piece") add_piece(piece);
    SpaceTag space;
    if (const XmlElement* fields = data.child("FieldData"))
      for (const XmlElement& field : fields->children)
        if (field.attribute("Name") == "SPACE" && field.attribute("type") == "String")
          space.see(source_, "SPACE=" + arrays_.text(field));
    return soup_.finish(space.value());
  }

  /// The scalars of all pieces, one after the other.
  std::vector<VertexScalar> scalars(const XmlElement& root) const {
    std::vector<VertexScalar> all;
    for (const XmlElement& piece : poly_data(root).children) {
      const XmlElement* fields = piece.name == "Piece" ? piece.child("PointData") : nullptr;
      if (fields == nullptr) continue;
      for (const XmlElement& array : fields->children) {
        if (array.attribute("NumberOfComponents", "1") != "1" || array.attribute("type") == "String")
          continue;
        const std::string name = array.attribute("Name");
        auto found = std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.name == name; });
        if (found == all.end()) found = all.insert(found, {name, {}});
        const std::vector<double> values = arrays_.numbers(array);
        found->values.insert(found->values.end(), values.begin(), values.end());
      }
    }
    return all;
  }

 private:
  const XmlElement& poly_data(const XmlElement& root) const {
    const XmlElement* data = root.child("PolyData");
    if (data == nullptr)
      source_.refuse("is no PolyData", "foramen reads surfaces, no images or grids: export the surface");
    return *data;
  }

  std::uint64_t count(const XmlElement& piece, const std::string& attribute) const {
    const std::string written = piece.attribute(attribute, "0");
    const auto number = to_integer(written);
    if (!number || *number < 0)
      source_.refuse("announces " + in_quotes(written) + " as " + attribute, remedy_export_again);
    return static_cast<std::uint64_t>(*number);
  }

  const XmlElement& child(const XmlElement& piece, const char* name) const {
    const XmlElement* found = piece.child(name);
    if (found == nullptr) source_.refuse("has no <" + std::string(name) + ">", remedy_export_again);
    return *found;
  }

  void add_piece(const XmlElement& piece) {
    const std::uint64_t points = count(piece, "NumberOfPoints"), faces = count(piece, "NumberOfPolys"),
                        strips = count(piece, "NumberOfStrips");
    soup_.pass_over_loose(count(piece, "NumberOfVerts"));
    soup_.pass_over_loose(count(piece, "NumberOfLines"));
    if (points == 0 && faces == 0 && strips == 0) return;
    const std::size_t first = soup_.points();
    const auto coordinates = arrays_.numbers(arrays_.find(child(piece, "Points"), "Points"));
    if (coordinates.size() % 3 != 0 || coordinates.size() / 3 != points)
      refuse_count("Points", coordinates.size(), "3 x " + std::to_string(points));
    soup_.expect(first + points, soup_.triangles(), source_.bytes.size(), 0, 0);
    for (std::size_t v = 0; v < points; ++v)
      soup_.add_point({coordinates[3 * v], coordinates[3 * v + 1], coordinates[3 * v + 2]},
                      [&] { return "vertex " + std::to_string(first + v); });
    if (faces > 0) add_cells(child(piece, "Polys"), faces, first, false);
    if (strips > 0) add_cells(child(piece, "Strips"), strips, first, true);
  }

  void add_cells(const XmlElement& element, std::uint64_t cells, std::size_t first, bool strips) {
    auto corners = arrays_.integers(arrays_.find(element, "connectivity"));
    const auto ends = arrays_.integers(arrays_.find(element, "offsets"));
    if (ends.size() != cells) refuse_count("offsets", ends.size(), std::to_string(cells));
    const std::uint64_t points = soup_.points() - first;
    std::int64_t begin = 0;
    for (std::size_t c = 0; c < ends.size(); begin = ends[c++]) {
      const std::int64_t end = ends[c];
      const auto place = [&] { return (strips ? "strip " : "face ") + std::to_string(c); };
      if (end < begin || end > std::ssize(corners))
        source_.refuse(place() + ": its offsets " + std::to_string(begin) + " and " + std::to_string(end) +
                           " are out of order or range",
                       remedy_export_again);
      const std::span cell = std::span(corners).subspan(begin, end - begin);
      for (std::int64_t& corner : cell) {
        if (corner < 0 || static_cast<std::uint64_t>(corner) >= points)
          soup_.refuse_corner(corner, points, place());
        corner += static_cast<std::int64_t>(first);
      }
      if (strips)
        soup_.add_strip(cell, soup_.points(), place);
      else
        soup_.add_face(cell, soup_.points(), place);
    }
  }

  [[noreturn]] void refuse_count(const std::string& array, std::size_t found,
                                 const std::string& expected) const {
    source_.refuse(
        "its array '" + array + "' holds " + std::to_string(found) + " numbers instead of " + expected,
        remedy_export_again);
  }

  const Source& source_;
  VtkDataArrays arrays_;
  SoupBuilder soup_;
};

}  // namespace

MeshFile parse_vtp(const Source& source) {
  const VtpFile file = split(source);
  return SurfaceReader(source, file).read(file.root);
}

std::vector<VertexScalar> parse_vtp_scalars(const Source& source) {
  const VtpFile file = split(source);
  return SurfaceReader(source, file).scalars(file.root);
}

}  // namespace foramen::io_detail
