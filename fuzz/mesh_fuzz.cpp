// Reads any bytes as a mesh of each format, inspects the mesh and builds it. The bytes must be refused with
// one of our errors, or the mesh must be valid.
#include <cstdlib>

#include "foramen/core/error.hpp"
#include "foramen/topology/inspect_mesh.hpp"
#include "fuzz_input.hpp"
#include "io/mesh_formats.hpp"

namespace foramen {
namespace {

void require(bool promise) {
  if (!promise) std::abort();
}

void build(const TriangleSoup& soup) {
  const MeshReport report = inspect_mesh(soup);
  const bool usable = !obstacle_to_model(report);
  try {
    const Mesh mesh = build_mesh(soup);
    require(!usable || (mesh.is_closed() && mesh.euler_characteristic() == 0));
  } catch (const InvalidInput&) {
    require(!usable);
  }
}

void check(const MeshFile& file) {
  require(!file.soup.triangles.empty());
  for (const Vec3& p : file.soup.points) require(p.allFinite());
  for (const auto& triangle : file.soup.triangles)
    for (const int corner : triangle) require(corner >= 0 && corner < std::ssize(file.soup.points));
  build(file.soup);
}

template <class Read>
void read_or_refuse(const Read& read) {
  try {
    check(read());
  } catch (const IoError&) {
  }
}

void fuzz(std::string_view bytes) {
  const io_detail::Source source{"fuzzed", bytes};
  for (const auto parse : {io_detail::parse_ply, io_detail::parse_stl, io_detail::parse_obj,
                           io_detail::parse_off, io_detail::parse_vtk, io_detail::parse_vtp})
    read_or_refuse([&] { return parse(source); });
}

}  // namespace
}  // namespace foramen

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  foramen::fuzz({reinterpret_cast<const char*>(data), size});
  return 0;
}
