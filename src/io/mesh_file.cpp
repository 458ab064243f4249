#include "foramen/io/mesh_file.hpp"

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
  return format->parse(source);
}

}  // namespace foramen
