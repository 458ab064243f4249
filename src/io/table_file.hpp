#pragma once
/// \file
/// Tables as CSV: quoting of RFC 4180, LF line ends, commas, and '.' as decimal point in every locale.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace foramen {

using Cell = std::variant<std::string, double, std::int64_t>;
using Row = std::vector<Cell>;

/// A table as it was read, all cells as text. Every row has as many cells as the header.
struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;

  /// Index of the column of that name. Throws IoError naming the column if there is none.
  std::size_t column(std::string_view name) const;
};

/// The shortest text that reads back as the same number; "nan", "inf" and "-inf" for values that are not
/// finite.
std::string format_number(double value);
/// Parses the whole cell as a number. Throws IoError if it is none.
double parse_number(std::string_view cell);

/// Writes a table. Throws InvalidInput if a row does not have the same number of cells as the header; IoError
/// if the file cannot be written.
void write_csv(const std::filesystem::path& path, const std::vector<std::string>& header,
               const std::vector<Row>& rows);

/// Reads LF or CRLF line ends and a byte-order mark. Throws IoError naming the line: an open quote, text
/// after a closing quote, a quote within a bare cell, a row of another length than the header, no header.
Table read_csv(const std::filesystem::path& path);

}  // namespace foramen
