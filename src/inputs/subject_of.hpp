#pragma once
/// \file
/// Whose shape it is, by the name of its file.

#include <string>

namespace foramen {

/// The subject of a shape: the pattern's first group (or whole match) in the stem; the stem itself if it does
/// not match. Throws InvalidInput if the pattern is no regular expression.
std::string subject_of(const std::string& stem, const std::string& pattern);

}  // namespace foramen
