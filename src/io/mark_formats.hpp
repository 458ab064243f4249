#pragma once
/// \file
/// Private to io: one reader per format of marks.

#include <filesystem>

#include <nlohmann/json.hpp>

#include "io/file_bytes.hpp"
#include "io/mark_file.hpp"

namespace foramen::io_detail {

/// The markups of a .mrk.json file of Slicer.
MarkFile parse_slicer_markups(const Source& source, const nlohmann::ordered_json& json);
MarkFile parse_fcsv(const Source& source);
MarkFile read_mark_table(const std::filesystem::path& path);

/// The space that a file of Slicer names. Throws IoError for another word.
AnatomicalSpace space_named(const Source& source, std::string_view word);

}  // namespace foramen::io_detail
