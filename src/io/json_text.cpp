#include "io/json_text.hpp"

#include "foramen/core/error.hpp"
#include "io/atomic_file.hpp"

namespace foramen::io_detail {

std::string json_text(std::string_view text) {
  try {
    return nlohmann::json(text).dump();
  } catch (const nlohmann::json::exception&) {
    throw InvalidInput("the text " + in_quotes(text) +
                       " is not UTF-8, as JSON demands; rename what it names");
  }
}

nlohmann::ordered_json parse_json(const Source& source) {
  try {
    return nlohmann::ordered_json::parse(source.bytes);
  } catch (const nlohmann::json::parse_error& e) {
    source.refuse("is not JSON (byte " + std::to_string(e.byte) + ")", remedy_export_again);
  } catch (const nlohmann::json::exception&) {
    source.refuse("holds a number that is too large", remedy_export_again);
  }
}

void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json) {
  std::string text;
  try {
    text = json.dump(2) + "\n";
  } catch (const nlohmann::json::exception&) {
    throw InvalidInput("cannot write " + path.string() +
                       ": a name in it is not UTF-8, as JSON demands; rename it");
  }
  write_file(path, text);
}

}  // namespace foramen::io_detail
