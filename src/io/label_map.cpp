#include "foramen/io/label_map.hpp"

#include <cstdio>
#include <fstream>
#include <utility>

#include "io/foreign_file.hpp"
#include "io/sha256.hpp"
#include "io/voxel_layout.hpp"

namespace foramen {
namespace {

using LayoutReader = io_detail::VoxelLayout (*)(const std::filesystem::path&);

struct Format {
  const char* extension;
  LayoutReader layout;
};

constexpr Format formats[] = {{".seg.nrrd", io_detail::nrrd_layout}, {".nii", io_detail::nifti_layout},
                              {".nii.gz", io_detail::nifti_layout},  {".nrrd", io_detail::nrrd_layout},
                              {".nhdr", io_detail::nrrd_layout},     {".mha", io_detail::meta_layout},
                              {".mhd", io_detail::meta_layout}};

// The format that the end of the name stands for; null if there is none.
const Format* format_of(const std::filesystem::path& path) {
  const std::string name = io_detail::lower_case(path.filename().string());
  for (const Format& format : formats)
    if (name.size() > std::string_view(format.extension).size() && name.ends_with(format.extension))
      return &format;
  return nullptr;
}

std::string sha256_of(const std::filesystem::path& path,
                      const std::vector<std::filesystem::path>& data_files) {
  if (data_files.front() == path) return sha256_of_file(path);
  std::vector<std::filesystem::path> parts{path};
  parts.insert(parts.end(), data_files.begin(), data_files.end());
  Sha256 hash;
  std::vector<char> chunk(std::size_t{1} << 20U);
  for (const auto& part : parts) {
    std::ifstream in(part, std::ios::binary);
    while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())), in.gcount() > 0)
      hash.update({chunk.data(), static_cast<std::size_t>(in.gcount())});
  }
  return hash.hex();
}

std::string rounding_note(double farthest) {
  char text[120];
  std::snprintf(text, sizeof text,
                "its labels are no whole numbers and were rounded, by %.2g at most; they went through "
                "floating point numbers",
                farthest);
  return text;
}

}  // namespace

const std::vector<std::string>& label_map_extensions() {
  static const std::vector<std::string> extensions = [] {
    std::vector<std::string> list;
    for (const Format& format : formats) list.emplace_back(format.extension);
    return list;
  }();
  return extensions;
}

bool is_label_map(const std::filesystem::path& path) { return format_of(path) != nullptr; }

std::string label_map_stem(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  const Format* format = format_of(path);
  return format ? name.substr(0, name.size() - std::string_view(format->extension).size()) : name;
}

std::vector<LabelMap> read_label_layers(const std::filesystem::path& path) {
  if (std::error_code failed; std::filesystem::is_regular_file(path, failed)) io_detail::refuse_foreign(path);
  const Format* format = format_of(path);
  if (!format) {
    std::string known;
    for (const std::string& e : label_map_extensions()) known += (known.empty() ? "" : " ") + e;
    io_detail::Source{path.string(), {}}.refuse("is no label map by its name",
                                                "label maps are read from files ending in " + known);
  }
  const io_detail::VoxelLayout layout = format->layout(path);
  io_detail::check_layout(path, layout);
  io_detail::VoxelLabels voxels = io_detail::read_voxels(path, layout);
  LabelMap map;
  for (std::size_t d = 0; d < 3; ++d) map.size[d] = static_cast<int>(layout.size[d]);
  for (const std::string& note : layout.notes) map.notes.emplace_back(note);
  // Single precision alone leaves about 1e-6, which is not worth a note.
  constexpr double worth_saying = 1e-5;
  if (voxels.farthest_rounded > worth_saying) map.notes.emplace_back(rounding_note(voxels.farthest_rounded));
  map.axes = layout.axes;
  map.origin = layout.origin;
  map.sha256 = sha256_of(path, layout.data_files);
  std::vector<LabelMap> layers(layout.layers, map);
  for (std::size_t l = 0; l < layers.size(); ++l) {
    if (l < layout.names.size()) layers[l].names = layout.names[l];
    if (layers.size() == 1)
      layers[l].labels = std::move(voxels.labels);
    else
      for (std::size_t i = l; i < voxels.labels.size(); i += layers.size())
        layers[l].labels.push_back(voxels.labels[i]);
  }
  return layers;
}

LabelMap read_label_map(const std::filesystem::path& path) {
  std::vector<LabelMap> layers = read_label_layers(path);
  if (layers.size() != 1)
    io_detail::Source{path.string(), {}}.refuse(
        "holds " + std::to_string(layers.size()) + " layers of segments",
        "save the segments in one layer, without overlap");
  return std::move(layers.front());
}

}  // namespace foramen
