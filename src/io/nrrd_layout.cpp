#ifdef FORAMEN_WITH_ITK
#include <algorithm>
#include <array>

#include "io/header_fields.hpp"
#include "io/voxel_layout.hpp"

namespace foramen::io_detail {
namespace {

struct TypeNames {
  std::int64_t bytes;
  std::array<const char*, 8> names;
};
constexpr std::array<TypeNames, 8> types{{
    {1, {"signed char", "int8", "int8_t", "uchar", "unsigned char", "uint8", "uint8_t", ""}},
    {2, {"short", "short int", "signed short", "signed short int", "int16", "int16_t", "", ""}},
    {2, {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t", "", "", ""}},
    {4, {"int", "signed int", "int32", "int32_t", "uint", "unsigned int", "uint32", "uint32_t"}},
    {8, {"longlong", "long long", "long long int", "signed long long", "signed long long int", "int64", "int64_t", ""}},
    {8, {"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t", "", "", ""}},
    {4, {"float", "", "", "", "", "", "", ""}},
    {8, {"double", "", "", "", "", "", "", ""}},
}};

std::int64_t bytes_of_type(const Source& source, const std::string& written) {
  const std::string type = lower_case(written);
  for (const TypeNames& t : types)
    for (const char* known : t.names)
      if (!type.empty() && type == known) return t.bytes;
  source.refuse("its voxels are of type " + in_quotes(written), "a label map holds one whole number a voxel");
}

// Fields until the blank line, or the end of a header whose data stand elsewhere.
std::int64_t parse_fields(const Source& source, HeaderFields& fields) {
  LineCursor lines(source.bytes);
  if (!header_line(source, lines).starts_with("NRRD000"))
    source.refuse("does not begin with 'NRRD000'", "it is no NRRD file: check its format and extension");
  while (lines.remaining() > 0) {
    const std::string_view line = header_line(source, lines);
    if (line.empty()) return static_cast<std::int64_t>(lines.offset());
    if (line.front() == '#' || line.find(":=") != std::string_view::npos) continue;
    const auto colon = line.find(": ");
    if (colon == std::string_view::npos)
      source.refuse(lines.place() + " of its header is " + in_quotes(line), remedy_export_again);
    std::string key = lower_case(line.substr(0, colon));
    // Both spellings are in use.
    std::erase(key, ' ');
    fields.add(key, line.substr(colon + 2));
  }
  if (!fields.has("datafile")) source.refuse("its header does not end", remedy_export_again);
  return static_cast<std::int64_t>(lines.offset());
}

// foramen measures in mm; NRRD may say otherwise.
void require_millimetres(const Source& source, const HeaderFields& fields) {
  for (const char* key : {"spaceunits", "units"}) {
    if (!fields.has(key)) continue;
    const std::string units = fields.text(key);
    for (auto open = units.find('"'); open != std::string::npos;) {
      const auto close = units.find('"', open + 1);
      if (close == std::string::npos) break;
      const std::string unit = units.substr(open + 1, close - open - 1);
      if (!unit.empty() && unit != "mm" && lower_case(unit) != "millimeter" && lower_case(unit) != "millimetre")
        source.refuse("its lengths are in " + in_quotes(unit), "convert it to millimetres");
      open = units.find('"', close + 1);
    }
  }
}

}  // namespace

VoxelLayout nrrd_layout(const std::filesystem::path& path) {
  const std::string header = header_text(path);
  const Source source{path.string(), header};
  HeaderFields fields(source);
  VoxelLayout layout;
  layout.offset = parse_fields(source, fields);
  layout.data_file = path;
  if (fields.integer("dimension") != 3)
    source.refuse("is an image of " + std::to_string(fields.integer("dimension")) +
                      " dimensions (colours and vectors count as one)",
                  "a label map has three: save one volume of it");
  const auto sizes = fields.integers("sizes");
  if (sizes.size() != 3) source.refuse("its header has not three sizes", remedy_export_again);
  std::copy(sizes.begin(), sizes.end(), layout.size.begin());
  layout.voxel_bytes = bytes_of_type(source, fields.text("type"));
  require_millimetres(source, fields);
  const std::string encoding = lower_case(fields.text("encoding"));
  if (encoding == "gzip" || encoding == "gz")
    layout.packing = VoxelLayout::Packing::from_offset;
  else if (encoding != "raw")
    source.refuse("its voxels are encoded as " + in_quotes(encoding), "save it with the encoding gzip or raw");
  for (const char* skip : {"lineskip", "byteskip"})
    if (fields.has(skip) && fields.integer(skip) != 0)
      source.refuse("its data file begins with something else (" + std::string(skip) + ")",
                    "save it as one .nrrd file");
  if (fields.has("datafile")) {
    layout.data_file = named_data_file(source, path, fields.text("datafile"));
    layout.offset = 0;
  }
  return layout;
}

}  // namespace foramen::io_detail
#endif
