// NRRD, https://teem.sourceforge.net/nrrd/format.html
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "io/header_fields.hpp"
#include "io/segment_names.hpp"
#include "io/voxel_layout.hpp"

namespace foramen::io_detail {
namespace {

struct TypeNames {
  NumberType type;
  std::array<std::string_view, 7> names;
};
constexpr NumberKind plain = NumberKind::unsigned_integer, with_sign = NumberKind::signed_integer;
constexpr std::array<TypeNames, 10> types{{
    {{plain, 1}, {"uchar", "unsigned char", "uint8", "uint8_t"}},
    {{with_sign, 1}, {"signed char", "int8", "int8_t"}},
    {{plain, 2}, {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}},
    {{with_sign, 2}, {"short", "short int", "signed short", "signed short int", "int16", "int16_t"}},
    {{plain, 4}, {"uint", "unsigned int", "uint32", "uint32_t"}},
    {{with_sign, 4}, {"int", "signed int", "int32", "int32_t"}},
    {{plain, 8}, {"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"}},
    {{with_sign, 8},
     {"longlong", "long long", "long long int", "signed long long", "signed long long int", "int64",
      "int64_t"}},
    {{NumberKind::real, 4}, {"float"}},
    {{NumberKind::real, 8}, {"double"}},
}};

NumberType type_of(const Source& source, const std::string& written) {
  const std::string type = lower_case(written);
  for (const TypeNames& t : types)
    if (!type.empty() && std::find(t.names.begin(), t.names.end(), type) != t.names.end()) return t.type;
  source.refuse("its voxels are of type " + in_quotes(written), "a label map holds one whole number a voxel");
}

// Reads the fields and the names of segments up to the blank line, to a list of data files, or to the end
// of a header whose data are in another file.
void parse_fields(const Source& source, LineCursor& lines, HeaderFields& fields, SegmentNames& segments) {
  // 3D Slicer writes the parameters of a segmentation into one line of several thousand characters.
  constexpr std::size_t longest = 100'000;
  if (!header_line(source, lines).starts_with("NRRD000"))
    source.refuse("does not begin with 'NRRD000'", "it is no NRRD file: check its format and extension");
  while (lines.remaining() > 0) {
    const std::string_view line = header_line(source, lines, longest);
    if (line.empty()) return;
    if (line.front() == '#') continue;
    if (const auto assigned = line.find(":="); assigned != std::string_view::npos) {
      segments.add(line.substr(0, assigned), line.substr(assigned + 2));
      continue;
    }
    const auto colon = line.find(": ");
    if (colon == std::string_view::npos)
      source.refuse(lines.place() + " of its header is " + in_quotes(line), remedy_export_again);
    std::string key = lower_case(line.substr(0, colon));
    // Keys are written with and without a blank, e.g. "space directions" and "spacedirections".
    std::erase(key, ' ');
    fields.add(key, line.substr(colon + 2));
    if (key == "datafile" && lower_case(TokenCursor(fields.text(key)).next()) == "list") return;
  }
  if (!fields.has("datafile")) source.refuse("its header does not end", remedy_export_again);
}

// foramen measures in mm, so a header that names another unit is refused.
void require_millimetres(const Source& source, const HeaderFields& fields) {
  for (const char* key : {"spaceunits", "units"}) {
    if (!fields.has(key)) continue;
    const std::string units = fields.text(key);
    for (auto open = units.find('"'); open != std::string::npos;) {
      const auto close = units.find('"', open + 1);
      if (close == std::string::npos) break;
      const std::string unit = units.substr(open + 1, close - open - 1);
      if (!unit.empty() && unit != "mm" && lower_case(unit) != "millimeter" &&
          lower_case(unit) != "millimetre")
        source.refuse("its lengths are in " + in_quotes(unit), "convert it to millimetres");
      open = units.find('"', close + 1);
    }
  }
}

// The signs by which coordinates in the space of the header become left, posterior, superior.
Vec3 lps_signs(const Source& source, const HeaderFields& fields) {
  const std::string space = lower_case(fields.text("space", ""));
  if (space == "left-posterior-superior" || space == "lps") return {1, 1, 1};
  if (space == "right-anterior-superior" || space == "ras") return {-1, -1, 1};
  if (space == "left-anterior-superior" || space == "las") return {1, -1, 1};
  source.refuse(
      space.empty() ? "does not say how it is oriented (no space)" : "its space is " + in_quotes(space),
      "save it with its orientation in left-posterior-superior or right-anterior-superior");
}

// The directions of all axes; nullopt for an axis that has none. Refuses what is no direction.
std::vector<std::optional<Vec3>> directions_of(const Source& source, const HeaderFields& fields) {
  const std::string key = "spacedirections";
  std::string_view rest = TokenCursor(fields.text(key)).rest();
  const auto refuse = [&] {
    source.refuse("its header has " + in_quotes(fields.text(key)) + " as " + key + ", not three directions",
                  remedy_export_again);
  };
  std::vector<std::optional<Vec3>> directions;
  while (!rest.empty()) {
    constexpr std::string_view none = "none";
    const bool absent = lower_case(rest.substr(0, none.size())) == none;
    const auto close = rest.find(')');
    if (!absent && (rest.front() != '(' || close == std::string_view::npos)) refuse();
    const std::size_t length = absent ? none.size() : close + 1;
    std::string numbers(absent ? std::string_view() : rest.substr(1, close - 1));
    std::replace(numbers.begin(), numbers.end(), ',', ' ');
    TokenCursor words(numbers);
    Vec3 direction = Vec3::Zero();
    for (double& value : direction) {
      const auto number = absent ? 0.0 : to_number(words.next());
      if (!number) refuse();
      value = *number;
    }
    if (!words.rest().empty()) refuse();
    directions.push_back(direction.allFinite() && !absent ? std::optional(direction) : std::nullopt);
    rest = TokenCursor(rest.substr(length)).rest();
  }
  return directions;
}

// Takes the three axes that have a direction. Further axes, without one, must have a single voxel, except
// that the first of four axes counts the layers of a segmentation.
void set_axes(const Source& source, const HeaderFields& fields, bool has_segments, VoxelLayout& layout) {
  const std::int64_t dimensions = fields.integer("dimension");
  const auto refuse_dimensions = [&] {
    source.refuse(
        "is an image of " + std::to_string(dimensions) + " dimensions (colours and vectors count as one)",
        "a label map has three: save one volume of it");
  };
  if (dimensions < 3) refuse_dimensions();
  const auto sizes = fields.integers("sizes");
  if (std::ssize(sizes) != dimensions)
    source.refuse(
        dimensions == 3 ? "its header has not three sizes" : "its header has not a size for each dimension",
        remedy_export_again);
  const Vec3 signs = lps_signs(source, fields);
  const auto directions = directions_of(source, fields);
  std::size_t taken = 0;
  for (std::size_t axis = 0; axis < sizes.size(); ++axis) {
    const bool placed = axis < directions.size() && directions[axis];
    if (!placed && dimensions > 3 && sizes[axis] == 1) continue;
    if (!placed && dimensions == 3)
      source.refuse("its header has " + in_quotes(fields.text("spacedirections")) +
                        " as spacedirections, not three directions",
                    remedy_export_again);
    if (!placed && axis == 0 && dimensions == 4 && has_segments) {
      layout.layers = sizes[axis];
      continue;
    }
    if (!placed || taken == 3) refuse_dimensions();
    layout.size[taken] = sizes[axis];
    layout.axes.col(static_cast<int>(taken++)) = signs.cwiseProduct(*directions[axis]);
  }
  if (taken != 3) refuse_dimensions();
  constexpr std::int64_t most_layers = 1000;
  if (layout.layers < 1 || layout.layers > most_layers)
    source.refuse("its header announces " + std::to_string(layout.layers) + " layers", remedy_export_again);
  const auto origin = fields.numbers("spaceorigin", 3);
  for (int row = 0; row < 3; ++row) layout.origin[row] = signs[row] * origin[row];
}

// Byte skip -1 means that the data are the last bytes of their file.
void set_skipped(const Source& source, const HeaderFields& fields, VoxelLayout& layout) {
  const std::int64_t lines = fields.has("lineskip") ? fields.integer("lineskip") : 0,
                     bytes = fields.has("byteskip") ? fields.integer("byteskip") : 0;
  if (lines != 0 || bytes < -1 || (bytes == -1 && layout.packing != ByteStream::Packing::none))
    source.refuse("its data file begins with something else (" +
                      std::string(lines != 0 ? "line skip" : "byte skip") + ")",
                  "save it as one .nrrd file");
  layout.at_end = bytes == -1;
  layout.skipped = std::max<std::int64_t>(0, bytes);
}

ByteOrder byte_order(const Source& source, const HeaderFields& fields, const NumberType& type) {
  if (type.bytes == 1) return ByteOrder::little;
  const std::string endian = lower_case(fields.text("endian"));
  if (endian == "little") return ByteOrder::little;
  if (endian == "big") return ByteOrder::big;
  source.refuse("its header has " + in_quotes(endian) + " as endian", remedy_export_again);
}

}  // namespace

VoxelLayout nrrd_layout(const std::filesystem::path& path) {
  const std::string header = header_text(path);
  const Source source{path.string(), header};
  HeaderFields fields(source);
  VoxelLayout layout;
  LineCursor lines(source.bytes);
  SegmentNames segments;
  parse_fields(source, lines, fields, segments);
  set_axes(source, fields, !segments.empty(), layout);
  layout.names = segments.by_layer(layout.layers);
  layout.type = type_of(source, fields.text("type"));
  layout.order = byte_order(source, fields, layout.type);
  require_millimetres(source, fields);
  const std::string encoding = lower_case(fields.text("encoding"));
  if (encoding == "gzip" || encoding == "gz")
    layout.packing = ByteStream::Packing::deflate;
  else if (encoding != "raw")
    source.refuse("its voxels are encoded as " + in_quotes(encoding),
                  "save it with the encoding gzip or raw");
  layout.offset = static_cast<std::int64_t>(lines.offset());
  layout.data_files = {path};
  if (fields.has("datafile")) {
    layout.data_files = named_data_files(source, path, fields.text("datafile"), lines);
    layout.offset = 0;
  }
  set_skipped(source, fields, layout);
  set_packing_by_content(layout);
  return layout;
}

}  // namespace foramen::io_detail
