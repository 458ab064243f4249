#pragma once

#include <string>
#include <string_view>

namespace foramen {

/// The page that is built from viewer/, with @REPORT_DATA@ in the place of the data; empty in a build without
/// npm. The function is defined in a file that cmake/ForamenViewer.cmake generates.
std::string_view viewer_template();

/// The template with the JSON data in the place of @REPORT_DATA@. The data is escaped so that it cannot end
/// the element around it. Throws InternalError unless the template contains @REPORT_DATA@ exactly once.
std::string filled_template(std::string_view page, std::string_view data);

}  // namespace foramen
