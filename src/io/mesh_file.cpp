#include "foramen/io/mesh_file.hpp"

#include <cstdint>
#include <string>
#include <string_view>

#include "foramen/core/error.hpp"
#include "foramen/io/label_map.hpp"
#include "io/foreign_file.hpp"
#include "io/mesh_formats.hpp"
#include "io/unpack.hpp"

namespace foramen {
namespace {

struct Format {
  const char* extension;
  MeshFile (*parse)(const io_detail::Source&);
};

constexpr Format formats[] = {{".ply", io_detail::parse_ply}, {".stl", io_detail::parse_stl},
                              {".obj", io_detail::parse_obj}, {".off", io_detail::parse_off},
                              {".vtk", io_detail::parse_vtk}, {".vtp", io_detail::parse_vtp}};

// The format that the end of the name stands for; null if there is none.
const Format* format_of(const std::filesystem::path& path) {
  const std::string name = io_detail::lower_case(path.filename().string());
  const std::string_view plain =
      std::string_view(name).substr(0, name.size() - (name.ends_with(".gz") ? 3 : 0));
  for (const Format& format : formats)
    if (plain.size() > std::string_view(format.extension).size() && plain.ends_with(format.extension))
      return &format;
  return nullptr;
}

bool is_whole_binary_stl(std::string_view bytes) {
  constexpr std::size_t header = 80, preamble = header + 4, facet = 50;
  if (bytes.size() < preamble + facet) return false;
  const std::uint64_t facets =
      io_detail::ByteCursor(bytes, header, io_detail::ByteOrder::little).read<std::uint32_t>();
  return bytes.size() == preamble + facet * facets;
}

// The extension of the format that the beginning of a file shows beyond doubt; empty where there is doubt.
// OBJ and OFF without its word have no mark.
std::string_view format_in(std::string_view bytes) {
  if (is_whole_binary_stl(bytes)) return ".stl";
  constexpr std::size_t looked_at = 1024;
  const std::string_view start = bytes.substr(io_detail::byte_order_mark(bytes), looked_at);
  if (start.starts_with("ply\n") || start.starts_with("ply\r")) return ".ply";
  if (start.starts_with("# vtk DataFile Version")) return ".vtk";
  if (start.starts_with("<VTKFile") ||
      (start.starts_with("<?xml") && start.find("<VTKFile") != std::string_view::npos))
    return ".vtp";
  if (start.starts_with("solid") && start.find("facet normal") != std::string_view::npos) return ".stl";
  if (start.starts_with("OFF\n") || start.starts_with("OFF\r")) return ".off";
  return {};
}

// The format of a file whose name stands for a format. The content decides, because many files have the name
// of another format.
const Format& format_of(const Format& by_name, std::string_view bytes) {
  const std::string_view found = format_in(bytes);
  for (const Format& format : formats)
    if (format.extension == found) return format;
  return by_name;
}

}  // namespace

const std::vector<std::string>& mesh_extensions() {
  static const std::vector<std::string> extensions = [] {
    std::vector<std::string> list;
    for (const Format& format : formats) list.emplace_back(format.extension);
    return list;
  }();
  return extensions;
}

bool is_mesh_file(const std::filesystem::path& path) { return format_of(path) != nullptr; }

std::string mesh_stem(const std::filesystem::path& path) {
  const bool packed = io_detail::lower_case(path.extension().string()) == ".gz" && is_mesh_file(path);
  return packed ? path.stem().stem().string() : path.stem().string();
}

MeshFile read_mesh(const std::filesystem::path& path) {
  if (is_label_map(path))
    throw InvalidInput(
        path.string() +
            ": is a label map, which holds voxels and no surface; make meshes of its labels first",
        {{RemedyKind::extract_surfaces}});
  std::error_code failed;
  if (std::filesystem::is_directory(path, failed))
    io_detail::Source{path.string(), {}}.refuse("is a folder", "name a mesh file in it");
  const Format* format = format_of(path);
  if (format == nullptr) {
    if (std::filesystem::is_regular_file(path, failed)) io_detail::refuse_foreign(path);
    const std::string extension = io_detail::lower_case(path.extension().string());
    std::string known;
    for (const std::string& e : mesh_extensions()) known += (known.empty() ? "" : " ") + e;
    io_detail::Source{path.string(), {}}.refuse(
        extension.empty() ? "has no extension"
                          : "has the unknown extension " + io_detail::in_quotes(extension),
        "meshes are read from files ending in " + known);
  }
  const std::string bytes = io_detail::unpacked_bytes(path);
  const io_detail::Source source{path.string(), bytes};
  io_detail::refuse_foreign(source);
  return format_of(*format, bytes).parse(source);
}

}  // namespace foramen
