#include "io/file_bytes.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <system_error>
#include <utility>

#include "foramen/core/error.hpp"

namespace foramen::io_detail {
namespace {

constexpr std::string_view blanks = " \t\v\f\r\n";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool is_word_character(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace

void Source::refuse(const std::string& found, const std::string& remedy) const {
  throw IoError(name + ": " + found + "; " + remedy);
}

std::uintmax_t require_readable(const std::filesystem::path& path) {
  const Source source{path.string(), {}};
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) source.refuse("no such file", "check the name and the folder");
  if (std::filesystem::is_directory(status)) source.refuse("is a folder", "name a file in it");
  if (!std::filesystem::is_regular_file(status))
    source.refuse("is not a regular file", "copy it to a file first");
  const auto size = std::filesystem::file_size(path, error);
  if (error) source.refuse("its size cannot be read (" + error.message() + ")", "check the permissions");
  if (size == 0) source.refuse("is empty", remedy_export_again);
  return size;
}

std::string read_bytes(const std::filesystem::path& path) {
  const Source source{path.string(), {}};
  const auto size = require_readable(path);
  std::ifstream in(path, std::ios::binary);
  if (!in)
    source.refuse("cannot be opened (" + std::generic_category().message(errno) + ")",
                  "check the permissions");
  std::string bytes(size, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(size));
  if (in.gcount() != static_cast<std::streamsize>(size))
    source.refuse(
        "only " + std::to_string(in.gcount()) + " of " + std::to_string(size) + " bytes could be read",
        "check the disk and copy the file again");
  return bytes;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string out = "'";
  for (char c : text.substr(0, longest)) out += c >= ' ' && c <= '~' ? c : '?';
  return out + (text.size() > longest ? "...'" : "'");
}

std::optional<double> to_number(std::string_view token) {
  if (token.starts_with('+')) token.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (token.empty() || error != std::errc() || end != token.data() + token.size()) return std::nullopt;
  return value;
}

std::optional<std::int64_t> to_integer(std::string_view token) {
  if (token.starts_with('+')) token.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (token.empty() || error != std::errc() || end != token.data() + token.size()) return std::nullopt;
  return value;
}

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

std::size_t byte_order_mark(std::string_view bytes) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  return bytes.starts_with(mark) ? mark.size() : 0;
}

bool LineCursor::next() {
  if (offset_ >= bytes_.size()) return false;
  const auto end = bytes_.find('\n', offset_);
  line_ = bytes_.substr(offset_, end == std::string_view::npos ? end : end - offset_);
  if (line_.ends_with('\r')) line_.remove_suffix(1);
  offset_ = end == std::string_view::npos ? bytes_.size() : end + 1;
  ++number_;
  return true;
}

bool LineCursor::next_filled() {
  while (next())
    if (!trimmed(line_).empty()) return true;
  return false;
}

std::string_view TokenCursor::next() {
  const auto first = rest_.find_first_not_of(blanks);
  if (first == std::string_view::npos) {
    rest_ = {};
    return {};
  }
  const auto end = std::min(rest_.find_first_of(blanks, first), rest_.size());
  const std::string_view token = rest_.substr(first, end - first);
  rest_.remove_prefix(end);
  return token;
}

std::string_view TokenCursor::rest() const { return trimmed(rest_); }

void SpaceTag::see(const Source& source, std::string_view text) {
  constexpr std::string_view key = "SPACE=";
  for (auto at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1)) {
    if (at > 0 && is_word_character(text[at - 1])) continue;
    std::string_view word = text.substr(at + key.size());
    word = word.substr(0, std::find_if_not(word.begin(), word.end(), is_word_character) - word.begin());
    const std::string axes = lower_case(word);
    if (axes != "lps" && axes != "ras")
      source.refuse("its SPACE tag says " + in_quotes(word),
                    "foramen knows LPS and RAS: convert the file to one of them");
    const AnatomicalSpace space = axes == "lps" ? AnatomicalSpace::lps : AnatomicalSpace::ras;
    if (value_ && *value_ != space)
      source.refuse("it is tagged both SPACE=LPS and SPACE=RAS", "remove the wrong tag from its header");
    value_ = space;
  }
}

std::string_view name(AnatomicalSpace space) { return space == AnatomicalSpace::lps ? "LPS" : "RAS"; }

}  // namespace foramen::io_detail
