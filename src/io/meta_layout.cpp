// MetaImage, https://itk.org/Wiki/MetaIO/Documentation
#include <algorithm>
#include <initializer_list>
#include <map>
#include <string>

#include "io/header_fields.hpp"
#include "io/voxel_layout.hpp"

namespace foramen::io_detail {
namespace {

NumberType type_of(const Source& source, const std::string& written) {
  static const std::map<std::string, NumberType> types{{"met_uchar", {NumberKind::unsigned_integer, 1}},
                                                       {"met_char", {NumberKind::signed_integer, 1}},
                                                       {"met_ushort", {NumberKind::unsigned_integer, 2}},
                                                       {"met_short", {NumberKind::signed_integer, 2}},
                                                       {"met_uint", {NumberKind::unsigned_integer, 4}},
                                                       {"met_int", {NumberKind::signed_integer, 4}},
                                                       {"met_ulong_long", {NumberKind::unsigned_integer, 8}},
                                                       {"met_long_long", {NumberKind::signed_integer, 8}},
                                                       {"met_float", {NumberKind::real, 4}},
                                                       {"met_double", {NumberKind::real, 8}}};
  const auto found = types.find(lower_case(written));
  if (found != types.end()) return found->second;
  source.refuse("its voxels are of type " + in_quotes(written), "a label map holds one whole number a voxel");
}

bool is_true(const std::string& value) {
  return value.starts_with('T') || value.starts_with('t') || value.starts_with('1');
}

// Reads the fields up to ElementDataFile, the last one of a header, and returns the position after it.
std::int64_t parse_fields(const Source& source, HeaderFields& fields) {
  LineCursor lines(source.bytes);
  while (!fields.has("elementdatafile")) {
    const std::string_view line = header_line(source, lines);
    if (TokenCursor(line).rest().empty()) continue;
    const auto equals = line.find('=');
    if (equals == std::string_view::npos)
      source.refuse(lines.place() + " of its header is " + in_quotes(line),
                    "it is no MetaImage file: check its format and extension");
    fields.add(line.substr(0, equals), line.substr(equals + 1));
  }
  return static_cast<std::int64_t>(lines.offset());
}

// The first of these fields that the header has; MetaImage has several names for some fields.
std::string first_of(const HeaderFields& fields, std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (fields.has(key)) return key;
  return *keys.begin();
}

// Sets the axes and the origin in LPS. A header without a matrix means the axes of the space.
void set_geometry(const HeaderFields& fields, VoxelLayout& layout) {
  const auto spacing = fields.numbers(first_of(fields, {"elementspacing", "elementsize"}), 3);
  const auto origin = fields.numbers(first_of(fields, {"offset", "position", "origin"}), 3);
  layout.axes = Mat3::Identity();
  const std::string matrix = first_of(fields, {"transformmatrix", "rotation", "orientation"});
  if (fields.has(matrix)) {
    const auto entries = fields.numbers(matrix, 9);
    for (int axis = 0; axis < 3; ++axis)
      for (int row = 0; row < 3; ++row) layout.axes(row, axis) = entries[3 * axis + row];
  }
  for (int d = 0; d < 3; ++d) {
    layout.axes.col(d) *= spacing[d];
    layout.origin[d] = origin[d];
  }
}

}  // namespace

VoxelLayout meta_layout(const std::filesystem::path& path) {
  const std::string header = header_text(path);
  const Source source{path.string(), header};
  HeaderFields fields(source);
  VoxelLayout layout;
  layout.offset = parse_fields(source, fields);
  layout.data_file = path;
  if (lower_case(fields.text("objecttype", "image")) != "image")
    source.refuse("holds an object of type " + in_quotes(fields.text("objecttype")),
                  "a label map is an Image");
  if (fields.integer("ndims") != 3)
    source.refuse("is an image of " + std::to_string(fields.integer("ndims")) + " dimensions",
                  "a label map has three: save one volume of it");
  if (fields.has("elementnumberofchannels") && fields.integer("elementnumberofchannels") != 1)
    source.refuse("has " + fields.text("elementnumberofchannels") + " numbers a voxel (colours or vectors)",
                  "a label map holds one whole number a voxel");
  const auto sizes = fields.integers("dimsize");
  if (sizes.size() != 3) source.refuse("its header has not three sizes", remedy_export_again);
  std::copy(sizes.begin(), sizes.end(), layout.size.begin());
  layout.type = type_of(source, fields.text("elementtype"));
  const std::string order = first_of(fields, {"binarydatabyteordermsb", "elementbyteordermsb"});
  layout.order = is_true(fields.text(order, "False")) ? ByteOrder::big : ByteOrder::little;
  set_geometry(fields, layout);
  if (!is_true(fields.text("binarydata", "False")))
    source.refuse("its voxels are written as text", "save it as binary data");
  if (fields.has("headersize") && fields.integer("headersize") != 0)
    source.refuse("its data file begins with something else (HeaderSize)", "save it as one .mha file");
  const std::string file = fields.text("elementdatafile");
  if (lower_case(file) != "local") {
    layout.data_file = named_data_file(source, path, file);
    layout.offset = 0;
  }
  if (!is_true(fields.text("compresseddata", "False"))) return layout;
  layout.packing = ByteStream::Packing::deflate;
  return layout;
}

}  // namespace foramen::io_detail
