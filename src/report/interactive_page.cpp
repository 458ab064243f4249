#include "report/interactive_page.hpp"

#include "foramen/core/error.hpp"
#include "report/viewer_template.hpp"

namespace foramen {

std::string filled_template(std::string_view page, std::string_view data) {
  constexpr std::string_view place = "@REPORT_DATA@";
  const std::size_t at = page.find(place);
  FORAMEN_ASSERT(at != std::string_view::npos && page.find(place, at + 1) == std::string_view::npos);
  std::string out(page.substr(0, at));
  out.reserve(page.size() + data.size());
  for (const char c : data)  // in JSON, < occurs only inside strings
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  return out.append(page.substr(at + place.size()));
}

bool has_viewer() { return !viewer_template().empty(); }

std::string interactive_html(std::string_view data) {
  FORAMEN_ASSERT(has_viewer());
  return filled_template(viewer_template(), data);
}

}  // namespace foramen
