#pragma once

#include <string>
#include <string_view>

namespace foramen {

/// The page that viewer/ builds, with @REPORT_DATA@ where the data belong; empty in a build without npm.
/// Defined in a file that cmake/ForamenViewer.cmake makes.
std::string_view viewer_template();

/// The template with JSON in the place of @REPORT_DATA@, written so that no text in it can end its element.
/// Throws InternalError unless there is one such place.
std::string filled_template(std::string_view page, std::string_view data);

}  // namespace foramen
