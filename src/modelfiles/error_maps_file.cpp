#include "modelfiles/error_maps_file.hpp"

#include <algorithm>

#include "foramen/core/error.hpp"
#include "foramen/evaluate/representation.hpp"
#include "io/hdf5_file.hpp"
#include "io/single_precision.hpp"

namespace foramen {
namespace {

std::string group_of(const std::string& name) { return "/shapes/" + name; }

std::vector<int> flips_of(const H5Reader& file, const std::string& path, int triangles) {
  const std::vector<std::int32_t> flips = file.vector<std::int32_t>(path);
  if (std::any_of(flips.begin(), flips.end(), [&](int f) { return f < 0 || f >= triangles; }))
    file.refuse(path, "an index that is none of " + std::to_string(triangles) + " triangles");
  return {flips.begin(), flips.end()};
}

}  // namespace

void write_error_maps(const std::filesystem::path& path, const std::vector<NamedErrorMap>& maps) {
  write_h5(path, [&](H5Writer& file) {
    for (const auto& [name, map] : maps) {
      const std::vector<float> landmark_mm(map.landmark_mm.begin(), map.landmark_mm.end());
      file.vector<float>(group_of(name) + "/landmark_mm", landmark_mm);
      file.vector<std::int32_t>(group_of(name) + "/plain_flips", map.plain_flips);
      file.vector<std::int32_t>(group_of(name) + "/confirmed_flips", map.confirmed_flips);
    }
  });
}

ErrorMap in_single_precision(ErrorMap map) {
  for (double& mm : map.landmark_mm) mm = rounded_to_single(mm);
  return map;
}

std::vector<ErrorMap> read_error_maps(const std::filesystem::path& path,
                                      const std::vector<std::string>& names, int landmarks, int triangles) {
  return read_h5(path, [&](const H5Reader& file) {
    std::vector<ErrorMap> maps;
    for (const std::string& name : names) {
      const std::string group = group_of(name);
      const std::vector<float> landmark_mm = file.vector<float>(group + "/landmark_mm");
      if (std::ssize(landmark_mm) != landmarks)
        file.refuse(group + "/landmark_mm", std::to_string(landmark_mm.size()) + " numbers for " +
                                                std::to_string(landmarks) + " landmarks");
      maps.push_back({{landmark_mm.begin(), landmark_mm.end()},
                      flips_of(file, group + "/plain_flips", triangles),
                      flips_of(file, group + "/confirmed_flips", triangles)});
    }
    return maps;
  });
}

}  // namespace foramen
