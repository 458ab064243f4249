// Repairs any small soup of triangles. The soup must be refused with one of our errors, or the result must be
// one closed surface of genus 1.
#include <cstdlib>

#include "foramen/core/error.hpp"
#include "foramen/repair/repair_mesh.hpp"
#include "foramen/topology/inspect_mesh.hpp"
#include "fuzz_input.hpp"
#include "soup_bytes.hpp"

namespace foramen {
namespace {

void require(bool promise) {
  if (!promise) std::abort();
}

void fuzz(std::string_view bytes) {
  const TriangleSoup raw = fuzzing::soup_from(bytes);
  try {
    const RepairedMesh repaired = repair_mesh(raw, {}, RunContext(1));
    require(!obstacle_to_model(inspect_mesh(repaired.mesh.soup())));
    require(repaired.origin.size() == repaired.mesh.vertex_count());
    for (VertexId v : repaired.mesh.vertices()) {
      const VertexId raw_vertex = repaired.origin[v];
      if (!raw_vertex.valid()) continue;
      require(raw_vertex.index < std::ssize(raw.points));
      const Vec3& before = raw.points[raw_vertex.index];
      require((repaired.mesh.position(v) - before).norm() <= repaired.report.largest_move_mm + 1e-9);
    }
  } catch (const Error&) {
  }
}

}  // namespace
}  // namespace foramen

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  foramen::fuzz({reinterpret_cast<const char*>(data), size});
  return 0;
}
