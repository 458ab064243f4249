#pragma once
/// \file
/// The interactive page of a report: the viewer, which is built from viewer/ and compiled into foramen, with
/// the data.

#include <string>
#include <string_view>

namespace foramen {

/// Whether this build of foramen holds the viewer (it is built where npm is found).
bool has_viewer();

/// One self-contained page that loads nothing else. \param data  JSON as docs/report.md defines it
/// \pre has_viewer()
std::string interactive_html(std::string_view data);

}  // namespace foramen
