#pragma once

#include <string>

#include "pages/page_contents.hpp"

namespace foramen {

/// The plain page. \param why  why it is this one
std::string plain_page(const ModelRecord& record, const PageContents& contents, const std::string& why);

}  // namespace foramen
