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

// Reads the fields up to ElementDataFile, the last one of a header.
void parse_fields(const Source& source, LineCursor& lines, HeaderFields& fields) {
  while (!fields.has("elementdatafile")) {
    const std::string_view line = header_line(source, lines);
    if (TokenCursor(line).rest().empty()) continue;
    const auto equals = line.find('=');
    if (equals == std::string_view::npos)
      source.refuse(lines.place() + " of its header is " + in_quotes(line),
                    "it is no MetaImage file: check its format and extension");
    fields.add(line.substr(0, equals), line.substr(equals + 1));
  }
}

// The numbers of a square matrix or vector for `dimensions` axes, without those of the axes after the third,
// which have one voxel.
std::vector<double> three_axes(const std::vector<double>& numbers, std::size_t dimensions) {
  std::vector<double> kept;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (i % dimensions < 3 && i / dimensions < 3) kept.push_back(numbers[i]);
  return kept;
}

// The first of these fields that the header has; MetaImage has several names for some fields.
std::string first_of(const HeaderFields& fields, std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (fields.has(key)) return key;
  return *keys.begin();
}

// Sets the axes and the origin in LPS. A header without a matrix means the axes of the space, one without an
// offset its origin, and one without spacing 1 mm, as in ITK.
void set_geometry(const HeaderFields& fields, std::size_t dimensions, VoxelLayout& layout) {
  const std::string size = first_of(fields, {"elementspacing", "elementsize"});
  const auto spacing =
      fields.has(size) ? fields.numbers(size, dimensions) : std::vector<double>(dimensions, 1.0);
  if (!fields.has(size))
    layout.notes.emplace_back("its header has no ElementSpacing: voxels of 1 mm were assumed");
  const std::string offset = first_of(fields, {"offset", "position", "origin"});
  const auto origin =
      fields.has(offset) ? fields.numbers(offset, dimensions) : std::vector<double>(dimensions, 0.0);
  layout.axes = Mat3::Identity();
  const std::string matrix = first_of(fields, {"transformmatrix", "rotation", "orientation"});
  if (fields.has(matrix)) {
    const auto entries = three_axes(fields.numbers(matrix, dimensions * dimensions), dimensions);
    for (int axis = 0; axis < 3; ++axis)
      for (int row = 0; row < 3; ++row) layout.axes(row, axis) = entries[3 * axis + row];
  }
  for (int d = 0; d < 3; ++d) {
    layout.axes.col(d) *= spacing[d];
    layout.origin[d] = origin[d];
  }
}

// Sets where the data are. HeaderSize = -1 means that they are the last bytes of their file.
void set_data(const Source& source, const std::filesystem::path& path, const HeaderFields& fields,
              const LineCursor& after, VoxelLayout& layout) {
  layout.offset = static_cast<std::int64_t>(after.offset());
  layout.data_files = {path};
  const std::string file = fields.text("elementdatafile");
  if (lower_case(file) != "local") {
    layout.data_files = named_data_files(source, path, file, after);
    layout.offset = 0;
  }
  const bool packed = is_true(fields.text("compresseddata", "False"));
  if (packed) layout.packing = ByteStream::Packing::deflate;
  if (const std::int64_t skipped = fields.has("headersize") ? fields.integer("headersize") : 0; skipped > 0)
    layout.offset = skipped;
  else if (skipped == -1 && !packed)
    layout.at_end = true;
  else if (skipped != 0)
    source.refuse("its HeaderSize is " + std::to_string(skipped) + (packed ? " of compressed data" : ""),
                  "save it as one .mha file");
  set_packing_by_content(layout);
}

}  // namespace

VoxelLayout meta_layout(const std::filesystem::path& path) {
  const std::string header = header_text(path);
  const Source source{path.string(), header};
  HeaderFields fields(source);
  VoxelLayout layout;
  LineCursor lines(source.bytes);
  parse_fields(source, lines, fields);
  if (lower_case(fields.text("objecttype", "image")) != "image")
    source.refuse("holds an object of type " + in_quotes(fields.text("objecttype")),
                  "a label map is an Image");
  const std::int64_t dimensions = fields.integer("ndims");
  const auto sizes = fields.integers("dimsize");
  constexpr std::int64_t most_dimensions = 10;
  if (dimensions < 3 || dimensions > most_dimensions ||
      std::any_of(sizes.begin() + std::min<std::ptrdiff_t>(3, std::ssize(sizes)), sizes.end(),
                  [](std::int64_t length) { return length != 1; }))
    source.refuse("is an image of " + std::to_string(dimensions) + " dimensions",
                  "a label map has three: save one volume of it");
  if (std::ssize(sizes) != dimensions)
    source.refuse("its header has " + std::to_string(sizes.size()) + " sizes for " +
                      std::to_string(dimensions) + " dimensions",
                  remedy_export_again);
  if (fields.has("elementnumberofchannels") && fields.integer("elementnumberofchannels") != 1)
    source.refuse("has " + fields.text("elementnumberofchannels") + " numbers a voxel (colours or vectors)",
                  "a label map holds one whole number a voxel");
  std::copy_n(sizes.begin(), 3, layout.size.begin());
  layout.type = type_of(source, fields.text("elementtype"));
  const std::string order = first_of(fields, {"binarydatabyteordermsb", "elementbyteordermsb"});
  layout.order = is_true(fields.text(order, "False")) ? ByteOrder::big : ByteOrder::little;
  set_geometry(fields, static_cast<std::size_t>(dimensions), layout);
  if (!is_true(fields.text("binarydata", "True")))
    source.refuse("its voxels are written as text", "save it as binary data");
  set_data(source, path, fields, lines, layout);
  return layout;
}

}  // namespace foramen::io_detail
