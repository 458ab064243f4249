#include "foramen/io/label_map.hpp"

#include <fstream>
#include <utility>

#include "foramen/io/sha256.hpp"
#include "io/file_bytes.hpp"
#include "io/itk_image.hpp"
#include "io/voxel_layout.hpp"

namespace foramen {
namespace {

// The extension of label_map_extensions() that the name ends with; empty if none.
std::string extension_of(const std::filesystem::path& path) {
  const std::string name = io_detail::lower_case(path.filename().string());
  for (const std::string& extension : label_map_extensions())
    if (name.size() > extension.size() && name.ends_with(extension)) return extension;
  return {};
}

}  // namespace

const std::vector<std::string>& label_map_extensions() {
  static const std::vector<std::string> extensions{".nii", ".nii.gz", ".nrrd", ".nhdr", ".mha", ".mhd"};
  return extensions;
}

bool is_label_map(const std::filesystem::path& path) { return !extension_of(path).empty(); }

std::string label_map_stem(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  return name.substr(0, name.size() - extension_of(path).size());
}

#ifdef FORAMEN_WITH_ITK

namespace {

using io_detail::ImageFormat;
using io_detail::Source;

std::pair<ImageFormat, io_detail::VoxelLayout> layout_of(const std::filesystem::path& path,
                                                         const Source& source) {
  const std::string extension = extension_of(path);
  if (extension == ".nii" || extension == ".nii.gz") return {ImageFormat::nifti, io_detail::nifti_layout(path)};
  if (extension == ".nrrd" || extension == ".nhdr") return {ImageFormat::nrrd, io_detail::nrrd_layout(path)};
  if (extension == ".mha" || extension == ".mhd") return {ImageFormat::meta, io_detail::meta_layout(path)};
  std::string known;
  for (const std::string& e : label_map_extensions()) known += (known.empty() ? "" : " ") + e;
  source.refuse("is no label map by its name", "label maps are read from files ending in " + known);
}

std::string millimetres(const Vec3& v) {
  return std::to_string(v.x()) + " x " + std::to_string(v.y()) + " x " + std::to_string(v.z()) + " mm";
}

void set_geometry(const Source& source, const io_detail::ItkImage& image, LabelMap& map) {
  const Vec3 spacing(image.spacing[0], image.spacing[1], image.spacing[2]);
  Mat3 direction = Mat3::Zero();
  for (int d = 0; d < 3; ++d)
    for (int row = 0; row < 3; ++row)
      direction(row, d) = image.direction[static_cast<std::size_t>(d)][static_cast<std::size_t>(row)];
  map.origin = Vec3(image.origin[0], image.origin[1], image.origin[2]);
  constexpr double smallest_mm = 1e-3, largest_mm = 100, farthest_mm = 1e6;
  if (!spacing.allFinite() || !(spacing.minCoeff() >= smallest_mm && spacing.maxCoeff() <= largest_mm))
    source.refuse("its voxels measure " + millimetres(spacing), "correct the spacing in its header");
  if (!map.origin.allFinite() || map.origin.cwiseAbs().maxCoeff() > farthest_mm)
    source.refuse("its origin is at " + millimetres(map.origin), "correct the origin in its header");
  constexpr double rounding = 1e-3;  // directions are often written with few digits
  if (!direction.allFinite() ||
      (direction.transpose() * direction - Mat3::Identity()).cwiseAbs().maxCoeff() > rounding)
    source.refuse("its axes are not at right angles", "resample it to a rectangular lattice");
  map.axes = direction * spacing.asDiagonal();
}

std::string sha256_of(const std::filesystem::path& path, const std::filesystem::path& data_file) {
  if (data_file == path) return sha256_of_file(path);
  Sha256 hash;
  std::vector<char> chunk(std::size_t{1} << 20U);
  for (const auto& part : {path, data_file}) {
    std::ifstream in(part, std::ios::binary);
    while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())), in.gcount() > 0)
      hash.update({chunk.data(), static_cast<std::size_t>(in.gcount())});
  }
  return hash.hex();
}

}  // namespace

LabelMap read_label_map(const std::filesystem::path& path) {
  const Source source{path.string(), {}};
  const auto [format, layout] = layout_of(path, source);
  io_detail::check_layout(path, layout);
  io_detail::ItkImage image = io_detail::read_with_itk(path, format, layout.size);
  LabelMap map;
  for (std::size_t d = 0; d < 3; ++d) map.size[d] = static_cast<int>(layout.size[d]);
  set_geometry(source, image, map);
  map.labels = std::move(image.labels);
  map.sha256 = sha256_of(path, layout.data_file);
  return map;
}

#else

LabelMap read_label_map(const std::filesystem::path& path) {
  io_detail::Source{path.string(), {}}.refuse(
      "this build of foramen reads no label maps (ITK was not found when it was built)",
      "install ITK 5 (Debian: libinsighttoolkit5-dev) and build foramen again");
}

#endif

}  // namespace foramen
