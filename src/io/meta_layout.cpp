#ifdef FORAMEN_WITH_ITK
#include <algorithm>

#include "io/header_fields.hpp"
#include "io/voxel_layout.hpp"

namespace foramen::io_detail {
namespace {

std::int64_t bytes_of_type(const Source& source, const std::string& written) {
  const std::string type = lower_case(written);
  if (type == "met_char" || type == "met_uchar") return 1;
  if (type == "met_short" || type == "met_ushort") return 2;
  if (type == "met_int" || type == "met_uint" || type == "met_float") return 4;
  if (type == "met_long_long" || type == "met_ulong_long" || type == "met_double") return 8;
  source.refuse("its voxels are of type " + in_quotes(written), "a label map holds one whole number a voxel");
}

bool is_true(const std::string& value) {
  return value.starts_with('T') || value.starts_with('t') || value.starts_with('1');
}

// ElementDataFile is the last field of a header. Returns where it ends.
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

}  // namespace

VoxelLayout meta_layout(const std::filesystem::path& path) {
  const std::string header = header_text(path);
  const Source source{path.string(), header};
  HeaderFields fields(source);
  VoxelLayout layout;
  layout.offset = parse_fields(source, fields);
  layout.data_file = path;
  if (lower_case(fields.text("objecttype", "image")) != "image")
    source.refuse("holds an object of type " + in_quotes(fields.text("objecttype")), "a label map is an Image");
  if (fields.integer("ndims") != 3)
    source.refuse("is an image of " + std::to_string(fields.integer("ndims")) + " dimensions",
                  "a label map has three: save one volume of it");
  if (fields.has("elementnumberofchannels") && fields.integer("elementnumberofchannels") != 1)
    source.refuse("has " + fields.text("elementnumberofchannels") + " numbers a voxel (colours or vectors)",
                  "a label map holds one whole number a voxel");
  const auto sizes = fields.integers("dimsize");
  if (sizes.size() != 3) source.refuse("its header has not three sizes", remedy_export_again);
  std::copy(sizes.begin(), sizes.end(), layout.size.begin());
  layout.voxel_bytes = bytes_of_type(source, fields.text("elementtype"));
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
  layout.packing = VoxelLayout::Packing::from_offset;
  const auto packed =
      static_cast<std::int64_t>(std::filesystem::file_size(layout.data_file)) - layout.offset;
  if (fields.has("compresseddatasize")) {
    const auto promised = fields.integer("compresseddatasize");
    if (promised < 0 || promised > packed)
      source.refuse("its header promises " + std::to_string(promised) + " compressed bytes, but " +
                        std::to_string(packed) + " follow",
                    remedy_export_again);
  }
  return layout;
}

}  // namespace foramen::io_detail
#endif
