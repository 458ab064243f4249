#include "foramen/io/mesh_file.hpp"

#include <string>

#include "foramen/core/error.hpp"
#include "io/mesh_formats.hpp"

namespace foramen {
namespace {

using MemoryReader = MeshFile (*)(const io_detail::Source&);
using DiskReader = MeshFile (*)(const std::filesystem::path&);

struct Format {
  const char* extension;
  MemoryReader parse;  // one of the two
  DiskReader read;
};

constexpr Format formats[] = {
    {".ply", io_detail::parse_ply, nullptr}, {".stl", io_detail::parse_stl, nullptr},
    {".obj", io_detail::parse_obj, nullptr}, {".off", io_detail::parse_off, nullptr},
    {".vtk", io_detail::parse_vtk, nullptr}, {".vtp", nullptr, io_detail::read_vtp}};

bool in_this_build(const Format& format) {
#ifdef FORAMEN_WITH_VTK
  return format.parse || format.read;
#else
  return format.parse != nullptr;
#endif
}

}  // namespace

const std::vector<std::string>& mesh_extensions() {
  static const std::vector<std::string> extensions = [] {
    std::vector<std::string> list;
    for (const Format& format : formats)
      if (in_this_build(format)) list.emplace_back(format.extension);
    return list;
  }();
  return extensions;
}

MeshFile read_mesh(const std::filesystem::path& path) {
  const std::string extension = io_detail::lower_case(path.extension().string());
  for (const Format& format : formats) {
    if (extension != format.extension) continue;
    if (format.read) return format.read(path);
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
