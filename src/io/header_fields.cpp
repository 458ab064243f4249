#include "io/header_fields.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

namespace foramen::io_detail {

void HeaderFields::add(std::string_view key, std::string_view value) {
  const auto [place, is_new] =
      values_.emplace(lower_case(TokenCursor(key).rest()), std::string(TokenCursor(value).rest()));
  if (!is_new) source_.refuse("its header has " + in_quotes(place->first) + " twice", remedy_export_again);
}

const std::string& HeaderFields::text(const std::string& key) const {
  const auto found = values_.find(key);
  if (found == values_.end()) source_.refuse("its header has no " + in_quotes(key), remedy_export_again);
  return found->second;
}

std::string HeaderFields::text(const std::string& key, const std::string& missing) const {
  const auto found = values_.find(key);
  return found == values_.end() ? missing : found->second;
}

std::vector<std::int64_t> HeaderFields::integers(const std::string& key) const {
  std::vector<std::int64_t> numbers;
  TokenCursor words(text(key));
  for (auto word = words.next(); !word.empty(); word = words.next()) {
    const auto number = to_integer(word);
    if (!number) source_.refuse("its header has " + in_quotes(word) + " in " + key, remedy_export_again);
    numbers.push_back(*number);
  }
  return numbers;
}

std::int64_t HeaderFields::integer(const std::string& key) const {
  const auto numbers = integers(key);
  if (numbers.size() != 1)
    source_.refuse("its header has " + in_quotes(text(key)) + " as " + key, remedy_export_again);
  return numbers.front();
}

std::vector<double> HeaderFields::numbers(const std::string& key, std::size_t count,
                                          std::string_view skip) const {
  std::string plain = text(key);
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  std::vector<double> numbers;
  TokenCursor words(plain);
  auto word = words.next();
  if (!skip.empty() && word == skip) word = words.next();
  for (; !word.empty(); word = words.next())
    numbers.push_back(to_number(word).value_or(std::numeric_limits<double>::quiet_NaN()));
  const bool finite = std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
  if (numbers.size() != count || !finite)
    source_.refuse("its header has " + in_quotes(text(key)) + " as " + key + ", not " +
                       std::to_string(count) + " numbers",
                   remedy_export_again);
  return numbers;
}

std::string header_text(const std::filesystem::path& path) {
  constexpr std::uintmax_t longest = 1U << 20U;
  std::string bytes(std::min(require_readable(path), longest), '\0');
  std::ifstream in(path, std::ios::binary);
  if (!in) Source{path.string(), {}}.refuse("cannot be opened", "check the permissions");
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(in.gcount());
  return bytes;
}

std::string_view header_line(const Source& source, LineCursor& lines, std::size_t longest) {
  if (!lines.next()) source.refuse("its header does not end", remedy_export_again);
  if (lines.line().size() > longest)
    source.refuse(lines.place() + " of its header has " + std::to_string(lines.line().size()) + " characters",
                  remedy_export_again);
  return lines.line();
}

std::filesystem::path named_data_file(const Source& source, const std::filesystem::path& header,
                                      const std::string& name) {
  if (name.empty() || lower_case(name).starts_with("list") || name.find('%') != std::string::npos)
    source.refuse("its voxels are spread over several files (" + in_quotes(name) + ")",
                  "save it as one file, best as .nii.gz or .nrrd");
  std::filesystem::path file = name;
  if (file.is_relative()) file = header.parent_path() / file;
  std::error_code failed;
  if (!std::filesystem::is_regular_file(file, failed))
    source.refuse("names the data file " + in_quotes(name) + ", which is not there",
                  "put it beside the header, or save both as one file");
  return file;
}

}  // namespace foramen::io_detail
