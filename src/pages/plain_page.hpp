#pragma once

#include <string>

#include "pages/page_contents.hpp"

namespace foramen {

/// The plain page. \param why  the reason for which the page is plain
std::string plain_page(const ModelRecord& record, const PageContents& contents, const std::string& why);

}  // namespace foramen
