#pragma once
/// \file
/// The subject of a shape, from the name of its file.

#include <string>

namespace foramen {

/// The subject of a shape: what the pattern's first group matches in the stem, or the whole match if the
/// pattern has no group. It is the stem itself if the pattern does not match. Throws InvalidInput if the
/// pattern is no regular expression.
std::string subject_of(const std::string& stem, const std::string& pattern);

}  // namespace foramen
