#include "foramen/io/mesh_file.hpp"

#include <string>

#include "foramen/core/error.hpp"
#include "foramen/io/label_map.hpp"
#include "io/mesh_formats.hpp"

namespace foramen {
namespace {

struct Format {
  const char* extension;
  MeshFile (*parse)(const io_detail::Source&);
};

constexpr Format formats[] = {{".ply", io_detail::parse_ply}, {".stl", io_detail::parse_stl},
                              {".obj", io_detail::parse_obj}, {".off", io_detail::parse_off},
                              {".vtk", io_detail::parse_vtk}, {".vtp", io_detail::parse_vtp}};

}  // namespace

const std::vector<std::string>& mesh_extensions() {
  static const std::vector<std::string> extensions = [] {
    std::vector<std::string> list;
    for (const Format& format : formats) list.emplace_back(format.extension);
    return list;
  }();
  return extensions;
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
  const std::string extension = io_detail::lower_case(path.extension().string());
  for (const Format& format : formats) {
    if (extension != format.extension) continue;
    const std::string bytes = io_detail::read_bytes(path);
    return format.parse({path.string(), bytes});
  }
  std::string known;
  for (const std::string& e : mesh_extensions()) known += (known.empty() ? "" : " ") + e;
  io_detail::Source{path.string(), {}}.refuse(
      extension.empty() ? "has no extension" : "has the unknown extension " + io_detail::in_quotes(extension),
      "meshes are read from files ending in " + known);
}

}  // namespace foramen
