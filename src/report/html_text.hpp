#pragma once

#include <string>
#include <string_view>

namespace foramen {

/// The text escaped for HTML and SVG, for use in elements and in quoted attributes.
std::string html_escaped(std::string_view text);
/// Standard Base64 (RFC 4648) with padding.
std::string base64(std::string_view bytes);

}  // namespace foramen
