#pragma once

#include "pages/page_contents.hpp"

namespace foramen {

/// The data of the interactive page, as docs/report.md defines them. Throws IoError if the record contains
/// something that the page cannot represent.
nlohmann::ordered_json report_data(const ModelRecord& record, const PageContents& contents);

}  // namespace foramen
