// Reads any bytes as a label map of each format. If the map is small, the surface of a label is extracted,
// without its distances, which would take most of the time.
#include <cstdlib>

#include "extract/binary_volume.hpp"
#include "extract/smooth_surface.hpp"
#include "extract/voxel_surface.hpp"
#include "foramen/core/error.hpp"
#include "foramen/topology/inspect_mesh.hpp"
#include "fuzz_input.hpp"
#include "io/voxel_layout.hpp"

namespace foramen {
namespace {

constexpr std::int64_t most_voxels = 4096;

void require(bool promise) {
  if (!promise) std::abort();
}

void require_surface(const TriangleSoup& surface) {
  const MeshReport report = inspect_mesh(surface);
  require(report.closed() && report.manifold() && report.oriented() && report.components == 1 &&
          !report.inward);
}

void extract_first_label(const LabelMap& map) {
  const auto labels = find_labels(map);
  if (labels.empty()) return;
  const auto& [label, extent] = *labels.begin();
  for (const EdgeContact contact : {EdgeContact::joined, EdgeContact::apart}) {
    extract::BinaryVolume volume = extract::binary_volume(map, label, extent);
    const extract::Cleaning cleaning = keep_largest_component(volume, contact);
    TriangleSoup surface = voxel_surface(volume, contact);
    require_surface(surface);
    for (Vec3& p : surface.points) p = p.cwiseProduct(volume.spacing());
    const double voxels = static_cast<double>(cleaning.kept_voxels + cleaning.filled_voxels);
    surface.points =
        extract::smooth_surface(surface, volume.spacing(), voxels * volume.spacing().prod(), 3, 0.5).points;
    require_surface(surface);
  }
}

void fuzz(std::string_view bytes) {
  const fuzzing::MemoryFile file(bytes);
  for (const auto layout_of : {io_detail::nifti_layout, io_detail::nrrd_layout, io_detail::meta_layout}) try {
      const io_detail::VoxelLayout layout = layout_of(file.path());
      io_detail::check_layout(file.path(), layout);
      LabelMap map;
      map.labels = io_detail::read_voxels(file.path(), layout).labels;
      for (std::size_t d = 0; d < 3; ++d) map.size[d] = static_cast<int>(layout.size[d]);
      require(std::ssize(map.labels) == layout.size[0] * layout.size[1] * layout.size[2]);
      map.axes = layout.axes;
      map.origin = layout.origin;
      if (std::ssize(map.labels) <= most_voxels) extract_first_label(map);
    } catch (const IoError&) {
    }
}

}  // namespace
}  // namespace foramen

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  foramen::fuzz({reinterpret_cast<const char*>(data), size});
  return 0;
}
