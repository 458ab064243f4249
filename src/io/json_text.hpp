#pragma once
/// \file
/// Private to io: reading and writing JSON.

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "io/file_bytes.hpp"

namespace foramen::io_detail {

/// The text as a JSON string literal. Throws InvalidInput if it is not UTF-8.
std::string json_text(std::string_view text);

/// Throws IoError if the source is not JSON.
nlohmann::ordered_json parse_json(const Source& source);

/// Writes JSON with two spaces of indentation per level and a final line end. Throws InvalidInput if a text
/// is not UTF-8; IoError if the file cannot be written.
void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json);

}  // namespace foramen::io_detail
