// Any bytes, read as a label map of every format; the surface of each label of a small one.
#include <cstdlib>

#include "foramen/core/error.hpp"
#include "foramen/extract/extract_label.hpp"
#include "foramen/topology/inspect_mesh.hpp"
#include "fuzz_input.hpp"
#include "io/voxel_layout.hpp"

namespace foramen {
namespace {

// What one input may cost.
constexpr std::int64_t most_voxels = 4096;
constexpr int most_labels = 2;

void require(bool promise) {
  if (!promise) std::abort();
}

void extract(const LabelMap& map) {
  int left = most_labels;
  for (const auto& [label, extent] : find_labels(map)) {
    if (left-- == 0) return;
    try {
      const ExtractedSurface extracted = extract_label(map, label, extent, {.keep_cut = true});
      const MeshReport report = inspect_mesh(extracted.surface);
      require(report.closed() && report.manifold() && report.oriented() && report.components == 1 &&
              !report.inward);
    } catch (const Error&) {
    }
  }
}

void fuzz(std::string_view bytes) {
  const fuzzing::MemoryFile file(bytes);
  for (const auto layout_of : {io_detail::nifti_layout, io_detail::nrrd_layout, io_detail::meta_layout}) try {
      const io_detail::VoxelLayout layout = layout_of(file.path());
      io_detail::check_layout(file.path(), layout);
      LabelMap map;
      map.labels = io_detail::read_voxels(file.path(), layout);
      for (std::size_t d = 0; d < 3; ++d) map.size[d] = static_cast<int>(layout.size[d]);
      require(std::ssize(map.labels) == layout.size[0] * layout.size[1] * layout.size[2]);
      map.axes = layout.axes;
      map.origin = layout.origin;
      if (std::ssize(map.labels) <= most_voxels) extract(map);
    } catch (const IoError&) {
    }
}

}  // namespace
}  // namespace foramen

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  foramen::fuzz({reinterpret_cast<const char*>(data), size});
  return 0;
}
