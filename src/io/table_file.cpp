#include "io/table_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "foramen/core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/file_bytes.hpp"

namespace foramen {
namespace {

using io_detail::in_quotes;
using io_detail::Source;

std::string cell_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}
std::string cell_text(double value) { return format_number(value); }
std::string cell_text(std::int64_t value) { return std::to_string(value); }

template <class Cells, class Text>
void append_row(std::string& out, const Cells& cells, const Text& text) {
  // A row of one empty cell is quoted, because it would be a blank line.
  if (cells.size() == 1 && text(cells[0]).empty()) {
    out += "\"\"\n";
    return;
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) out += ',';
    out += text(cells[i]);
  }
  out += '\n';
}

class CsvParser {
 public:
  explicit CsvParser(const Source& source)
      : source_(source), rest_(source.bytes.substr(io_detail::byte_order_mark(source.bytes))) {}

  Table parse() {
    Table table;
    table.header = parse_row();
    if (table.header.size() == 1 && table.header[0].empty())
      source_.refuse("has no header", "name its columns in line 1");
    while (!rest_.empty()) {
      const std::size_t line = line_;
      table.rows.push_back(parse_row());
      if (table.rows.back().size() != table.header.size())
        source_.refuse("line " + std::to_string(line) + ": " + std::to_string(table.rows.back().size()) +
                           " cells, but the header has " + std::to_string(table.header.size()),
                       "correct that line");
    }
    return table;
  }

 private:
  [[noreturn]] void refuse(const std::string& found) const {
    source_.refuse("line " + std::to_string(line_) + ": " + found, "quote such cells as RFC 4180 says");
  }

  // Skips a line end if there is one; true also at the end of the file.
  bool take_line_end() {
    if (rest_.empty()) return true;
    const std::size_t length = rest_.starts_with("\r\n") ? 2 : rest_.front() == '\n' ? 1 : 0;
    rest_.remove_prefix(length);
    if (length > 0) ++line_;
    return length > 0;
  }

  std::vector<std::string> parse_row() {
    std::vector<std::string> cells;
    for (;;) {
      cells.push_back(!rest_.empty() && rest_.front() == '"' ? parse_quoted() : parse_bare());
      if (take_line_end()) return cells;
      if (rest_.front() != ',') refuse("text after a closing quote");
      rest_.remove_prefix(1);
    }
  }

  std::string parse_bare() {
    std::size_t end = std::min(rest_.find_first_of(",\n"), rest_.size());
    if (end > 0 && end < rest_.size() && rest_[end] == '\n' && rest_[end - 1] == '\r') --end;
    const std::string_view cell = rest_.substr(0, end);
    if (cell.find('"') != std::string_view::npos) refuse("a quote within " + in_quotes(cell));
    rest_.remove_prefix(end);
    return std::string(cell);
  }

  std::string parse_quoted() {
    const std::size_t opened = line_;
    std::string cell;
    for (rest_.remove_prefix(1);; rest_.remove_prefix(1)) {
      if (rest_.empty())
        source_.refuse("line " + std::to_string(opened) + ": a quote that is never closed", "close it");
      if (rest_.starts_with("\"\"")) {
        rest_.remove_prefix(1);
      } else if (rest_.front() == '"') {
        rest_.remove_prefix(1);
        return cell;
      }
      if (rest_.front() == '\n') ++line_;
      cell += rest_.front();
    }
  }

  const Source& source_;
  std::string_view rest_;
  std::size_t line_ = 1;
};

}  // namespace

std::size_t Table::column(std::string_view name) const {
  const auto found = std::find(header.begin(), header.end(), name);
  if (found == header.end())
    throw IoError("the table has no column " + in_quotes(name) + "; check its header");
  return found - header.begin();
}

std::string format_number(double value) {
  if (std::isnan(value)) return "nan";  // to_chars() would write a sign for some NaN
  constexpr std::size_t longest = 32;   // "-1.7976931348623157e+308" has 24
  std::array<char, longest> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  FORAMEN_ASSERT(result.ec == std::errc());
  return {buffer.data(), result.ptr};
}

double parse_number(std::string_view cell) {
  const auto value = io_detail::to_number(cell);
  if (!value) throw IoError("expected a number, found " + in_quotes(cell) + "; correct that cell");
  return *value;
}

void write_csv(const std::filesystem::path& path, const std::vector<std::string>& header,
               const std::vector<Row>& rows) {
  std::string out;
  append_row(out, header, [](const std::string& text) { return cell_text(text); });
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (rows[r].size() != header.size())
      throw InvalidInput("cannot write " + path.string() + ": row " + std::to_string(r) + " has " +
                         std::to_string(rows[r].size()) + " cells, the header " +
                         std::to_string(header.size()));
    append_row(out, rows[r], [](const Cell& cell) {
      return std::visit([](const auto& value) { return cell_text(value); }, cell);
    });
  }
  write_file(path, out);
}

Table read_csv(const std::filesystem::path& path) {
  const std::string bytes = io_detail::read_bytes(path);
  const Source source{path.string(), bytes};
  return CsvParser(source).parse();
}

}  // namespace foramen
