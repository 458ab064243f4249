#pragma once
/// \file
/// Private to io: what files of corresponding points have in common.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "io/file_bytes.hpp"
#include "io/named_points.hpp"

namespace foramen::io_detail {

/// Throws InvalidInput unless there are specimens, all with as many finite points, at least one.
void check_specimens(const std::filesystem::path& path, std::span<const NamedPoints> specimens);

/// Throws IoError unless there are specimens with different names and as many points.
void check_read(const Source& source, std::span<const NamedPoints> specimens);

/// "x y z", shortest texts that read back as the same numbers.
std::string text_of(const Vec3& point);

/// Three numbers and nothing else on a line, or nothing.
std::optional<Vec3> point_of(std::string_view line);

}  // namespace foramen::io_detail
