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

namespace {

std::filesystem::path existing_file(const Source& source, const std::filesystem::path& file,
                                    const std::string& name) {
  std::error_code failed;
  if (!std::filesystem::is_regular_file(file, failed))
    source.refuse("names the data file " + in_quotes(name) + ", which is not there",
                  "put it beside the header, or save both as one file");
  return file;
}

// One of several files. A header that came with a download must not make us read elsewhere.
std::filesystem::path file_below(const Source& source, const std::filesystem::path& folder,
                                 const std::string& name) {
  const std::filesystem::path relative = name;
  bool outside = relative.empty() || relative.is_absolute();
  for (const auto& part : relative) outside |= part == "..";
  if (!outside) {
    std::error_code failed;
    const auto root = std::filesystem::weakly_canonical(folder.empty() ? "." : folder, failed),
               target = std::filesystem::weakly_canonical(folder / relative, failed);
    outside = std::mismatch(root.begin(), root.end(), target.begin(), target.end()).first != root.end();
  }
  if (outside)
    source.refuse("names the data file " + in_quotes(name) + " outside its own folder",
                  "put the files beside the header, or save all as one file, best as .nii.gz or .nrrd");
  return existing_file(source, folder / relative, name);
}

// The name with the number in place of its one "%d", "%3d" or "%03d"; nullopt if the pattern is another.
std::optional<std::string> numbered(const std::string& pattern, std::int64_t number) {
  const auto percent = pattern.find('%'), letter = pattern.find_first_not_of("0123456789", percent + 1);
  constexpr std::size_t most_digits = 3;
  if (letter == std::string::npos || (pattern[letter] != 'd' && pattern[letter] != 'i') ||
      letter - percent - 1 > most_digits || pattern.find('%', letter) != std::string::npos)
    return std::nullopt;
  const std::string format = pattern.substr(percent + 1, letter - percent - 1);
  std::string digits = std::to_string(number);
  const auto width = static_cast<std::size_t>(to_integer(format).value_or(0));
  if (digits.size() < width) digits.insert(0, width - digits.size(), format.front() == '0' ? '0' : ' ');
  return pattern.substr(0, percent) + digits + pattern.substr(letter + 1);
}

std::vector<std::filesystem::path> files_of_pattern(const Source& source, const std::filesystem::path& folder,
                                                    const std::string& field) {
  TokenCursor words(field);
  const std::string pattern(words.next());
  const auto first = to_integer(words.next()), last = to_integer(words.next());
  const std::string_view written_step = words.next();
  const auto step = written_step.empty() ? 1 : to_integer(written_step);
  constexpr std::int64_t largest = 1'000'000;
  if (!first || !last || !step || *step <= 0 || *first < 0 || *last < *first || *last > largest ||
      !numbered(pattern, *first))
    source.refuse("its voxels are spread over several files by the pattern " + in_quotes(field),
                  "foramen reads patterns such as 'slice_%03d.raw 1 50 1': save it as one file");
  std::vector<std::filesystem::path> files;
  for (std::int64_t number = *first; number <= *last; number += *step)
    files.push_back(file_below(source, folder, *numbered(pattern, number)));
  return files;
}

}  // namespace

std::vector<std::filesystem::path> named_data_files(const Source& source, const std::filesystem::path& header,
                                                    const std::string& field, LineCursor after) {
  const std::filesystem::path folder = header.parent_path();
  TokenCursor words(field);
  if (lower_case(words.next()) == "list") {
    std::vector<std::filesystem::path> files;
    while (after.next_filled())
      files.push_back(file_below(source, folder, std::string(TokenCursor(after.line()).rest())));
    if (files.empty()) source.refuse("its list of data files is empty", remedy_export_again);
    return files;
  }
  if (field.find('%') != std::string::npos) return files_of_pattern(source, folder, field);
  if (field.empty()) source.refuse("its header names no data file", remedy_export_again);
  std::filesystem::path file = field;
  if (file.is_relative()) file = folder / file;
  return {existing_file(source, file, field)};
}

}  // namespace foramen::io_detail
