#include "modelfiles/measures_file.hpp"

#include <limits>
#include <string>

#include <nlohmann/json.hpp>

#include "foramen/core/error.hpp"
#include "io/file_bytes.hpp"

namespace foramen {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::string& part, const std::string& expected) {
  throw InvalidInput("\"" + part + "\" is not " + expected + "; correct it");
}

Json parsed(const std::string& text) {
  try {
    return Json::parse(text);
  } catch (const nlohmann::json::parse_error& e) {
    throw InvalidInput("is no JSON from byte " + std::to_string(e.byte) + " on; correct it");
  } catch (const nlohmann::json::exception&) {
    throw InvalidInput("holds a number that is too large; correct it");
  }
}

int landmark(const std::string& name, const Json& item) {
  const bool is_index = item.is_number_integer() && item.get<double>() >= 0 &&
                        item.get<double>() <= std::numeric_limits<int>::max();
  if (!is_index) refuse(name, "made of landmarks' indices, 0, 1, 2 ...");
  return item.get<int>();
}

PlaceOnMean place(const std::string& name, const Json& item) {
  if (item.is_number_integer()) return landmark(name, item);
  const bool is_position = item.is_array() && item.size() == 3 && item[0].is_number() &&
                           item[1].is_number() && item[2].is_number();
  if (!is_position) refuse(name, "a landmark's index or a position [x, y, z] in mm");
  return Vec3(item[0].get<double>(), item[1].get<double>(), item[2].get<double>());
}

NamedDistance distance(const std::string& name, const Json& item) {
  if (!(item.is_array() && item.size() == 2 && item[0].is_string() && item[1].is_string()))
    refuse(name, "a pair of names of points [\"from\", \"to\"]");
  return {name, item[0].get<std::string>(), item[1].get<std::string>()};
}

NamedRegion region(const std::string& name, const Json& item) {
  if (item.is_object() && item.size() == 1 && item.contains("landmarks") && item["landmarks"].is_array()) {
    std::vector<int> landmarks;
    for (const Json& index : item["landmarks"]) landmarks.push_back(landmark(name, index));
    return {name, landmarks};
  }
  if (!(item.is_object() && item.size() == 2 && item.contains("centre") && item["centre"].is_string() &&
        item.contains("radius_mm") && item["radius_mm"].is_number()))
    refuse(name, "{\"centre\": a point's name, \"radius_mm\": number} or {\"landmarks\": [indices]}");
  return {name, NamedRegion::Ball{item["centre"].get<std::string>(), item["radius_mm"].get<double>()}};
}

}  // namespace

MeasureDefinitions parse_measures(const std::string& text) {
  const Json json = parsed(text);
  if (!json.is_object()) refuse("the file", "an object with points, distances and regions");
  MeasureDefinitions definitions;
  for (const auto& [part, items] : json.items()) {
    if (!items.is_object()) refuse(part, "an object of names");
    for (const auto& [name, item] : items.items()) {
      if (part == "points")
        definitions.points.push_back({name, place(name, item)});
      else if (part == "distances")
        definitions.distances.push_back(distance(name, item));
      else if (part == "regions")
        definitions.regions.push_back(region(name, item));
      else
        refuse(part, "one of points, distances, regions");
    }
  }
  return definitions;
}

MeasureDefinitions read_measures(const std::filesystem::path& path) {
  const std::string text = io_detail::read_bytes(path);
  try {
    return parse_measures(text);
  } catch (const InvalidInput& e) {
    throw IoError(path.string() + ": " + e.what());
  }
}

}  // namespace foramen
