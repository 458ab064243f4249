#pragma once
/// \file
/// Private to io: JSON in and out.

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "io/file_bytes.hpp"

namespace foramen::io_detail {

/// The text in quotes, as JSON writes it. Throws InvalidInput if it is not UTF-8.
std::string json_text(std::string_view text);

/// Throws IoError if the source is not JSON.
nlohmann::ordered_json parse_json(const Source& source);

/// Writes it with two spaces a level and a final line end. Throws InvalidInput if a text is not UTF-8,
/// IoError.
void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json);

}  // namespace foramen::io_detail
