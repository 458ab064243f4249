#pragma once
/// \file
/// Private to io: a sheet of a spreadsheet (.xlsx), as texts.

#include <map>
#include <string>
#include <vector>

#include "io/file_bytes.hpp"

namespace foramen::io_detail {

/// A row of a sheet by the names in the first row; without cells that are empty or have no name above.
using SheetRow = std::map<std::string, std::string>;

/// The rows below the first one, without those that are empty. Numbers are the texts in the file, and
/// formulas the values that were stored with them. Throws IoError if the bytes are no spreadsheet, if it
/// has no sheet of that name, or if what is read of it has more than 16 MiB when it is unpacked.
std::vector<SheetRow> read_sheet(const Source& source, const std::string& sheet);

}  // namespace foramen::io_detail
