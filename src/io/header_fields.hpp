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

/// The values of a text header by their keys in lower case.
class HeaderFields {
 public:
  explicit HeaderFields(const Source& source) : source_(source) {}
  /// Refuses a key that occurs twice.
  void add(std::string_view key, std::string_view value);
  bool has(const std::string& key) const { return values_.contains(key); }
  /// The value; refuses the file if there is none.
  const std::string& text(const std::string& key) const;
  /// The value, or `missing` if there is none.
  std::string text(const std::string& key, const std::string& missing) const;
  std::int64_t integer(const std::string& key) const;
  std::vector<std::int64_t> integers(const std::string& key) const;
  /// The numbers of a value; brackets and commas between them are ignored. Refuses a number of values other
  /// than `count`. A first word equal to `skip` is passed over.
  std::vector<double> numbers(const std::string& key, std::size_t count, std::string_view skip = {}) const;

 private:
  const Source& source_;
  std::map<std::string, std::string> values_;
};

/// The beginning of a file, which must contain its whole text header.
std::string header_text(const std::filesystem::path& path);

/// The next line of a text header; refuses a line with more characters than that.
std::string_view header_line(const Source& source, LineCursor& lines, std::size_t longest = 1000);

/// The data files that a header names: one file; the word LIST, after which one file name a line follows in
/// the header; or a pattern with a number, such as "slice_%03d.raw 1 50 1" (first, last, step). A relative
/// path starts from the folder of the header. Refuses a missing file, and several files that are not in the
/// folder of the header or below.
/// \param after  the lines of the header after the field
std::vector<std::filesystem::path> named_data_files(const Source& source, const std::filesystem::path& header,
                                                    const std::string& field, LineCursor after);

}  // namespace foramen::io_detail
