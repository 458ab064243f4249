#include "io/scalismo_landmarks.hpp"

#include <set>

#include "foramen/core/error.hpp"
#include "io/json_text.hpp"

namespace foramen {

using nlohmann::ordered_json;

void write_scalismo_landmarks(const std::filesystem::path& path,
                              std::span<const ScalismoLandmark> landmarks) {
  ordered_json list = ordered_json::array();
  std::set<std::string> ids;
  for (const ScalismoLandmark& landmark : landmarks) {
    if (landmark.id.empty() || !ids.insert(landmark.id).second || !landmark.position.allFinite())
      throw InvalidInput("cannot write " + path.string() + ": the landmark " +
                         io_detail::in_quotes(landmark.id) +
                         " has no id of its own, or a coordinate that is not finite");
    const Vec3& p = landmark.position;
    list.push_back({{"id", landmark.id}, {"coordinates", {p.x(), p.y(), p.z()}}});
    if (!landmark.description.empty()) list.back()["description"] = landmark.description;
  }
  io_detail::write_json(path, list);
}

std::vector<ScalismoLandmark> read_scalismo_landmarks(const std::filesystem::path& path) {
  const std::string bytes = io_detail::read_bytes(path);
  const io_detail::Source source{path.string(), bytes};
  const ordered_json list = io_detail::parse_json(source);
  if (!list.is_array()) source.refuse("is no list of landmarks", io_detail::remedy_export_again);
  std::vector<ScalismoLandmark> landmarks;
  std::set<std::string> ids;
  for (const ordered_json& item : list) {
    const auto refuse = [&](const std::string& what) {
      source.refuse("landmark " + std::to_string(landmarks.size() + 1) + " " + what, "correct it");
    };
    if (!item.is_object() || !item.contains("id") || !item.at("id").is_string()) refuse("has no id");
    ScalismoLandmark landmark{item.at("id").get<std::string>(), {}, {}};
    if (!ids.insert(landmark.id).second) refuse("has the id of another");
    const ordered_json coordinates = item.value("coordinates", ordered_json());
    if (!coordinates.is_array() || coordinates.size() != 3) refuse("has not three coordinates");
    for (int k = 0; k < 3; ++k) {
      const ordered_json& number = coordinates.at(k);
      if (!number.is_number()) refuse("has a coordinate that is no number");
      landmark.position[k] = number.get<double>();
    }
    if (item.contains("description") && item.at("description").is_string())
      landmark.description = item.at("description").get<std::string>();
    landmarks.push_back(std::move(landmark));
  }
  return landmarks;
}

}  // namespace foramen
