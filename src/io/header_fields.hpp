#pragma once
/// \file
/// Private to io: the lines of a text header as keys and values.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/file_bytes.hpp"

namespace foramen::io_detail {

/// The values of a header by their keys in lower case.
class HeaderFields {
 public:
  explicit HeaderFields(const Source& source) : source_(source) {}
  /// Refuses a key that was there before.
  void add(std::string_view key, std::string_view value);
  bool has(const std::string& key) const { return values_.contains(key); }
  /// The value; refuses if there is none.
  const std::string& text(const std::string& key) const;
  /// The value, or that default.
  std::string text(const std::string& key, const std::string& missing) const;
  std::int64_t integer(const std::string& key) const;
  std::vector<std::int64_t> integers(const std::string& key) const;
  /// The numbers of a value, whatever brackets and commas stand between them; refuses another count.
  std::vector<double> numbers(const std::string& key, std::size_t count) const;

 private:
  const Source& source_;
  std::map<std::string, std::string> values_;
};

/// The beginning of a file in which its text header must be.
std::string header_text(const std::filesystem::path& path);

/// The next line of a text header; refuses one so long that it is none.
std::string_view header_line(const Source& source, LineCursor& lines);

/// The data file that a header names, in the header's folder unless the path is absolute; refuses one that is
/// not there, lists of files and patterns.
std::filesystem::path named_data_file(const Source& source, const std::filesystem::path& header,
                                      const std::string& name);

}  // namespace foramen::io_detail
