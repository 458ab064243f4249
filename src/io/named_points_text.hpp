#pragma once
/// \file
/// Private to io: checks and texts that all files of corresponding points share.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "io/file_bytes.hpp"
#include "io/named_points.hpp"

namespace foramen::io_detail {

/// Throws InvalidInput unless there is a specimen and all specimens have the same number (at least 1) of
/// finite points.
void check_specimens(const std::filesystem::path& path, std::span<const NamedPoints> specimens);

/// Throws IoError unless there is a specimen, all names differ and all specimens have the same number of
/// points.
void check_read(const Source& source, std::span<const NamedPoints> specimens);

/// "x y z"; each number is the shortest text that reads back as the same double.
std::string text_of(const Vec3& point);

/// The point of a line that consists of three numbers; nullopt for any other line.
std::optional<Vec3> point_of(std::string_view line);

}  // namespace foramen::io_detail
