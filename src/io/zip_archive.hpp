#pragma once
/// \file
/// Private to io: the files in a zip archive.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "io/file_bytes.hpp"

namespace foramen::io_detail {

bool is_zip(std::string_view bytes);

/// An archive in memory, whose files are unpacked when they are asked for.
class ZipArchive {
 public:
  /// Throws IoError if the list of files at the end of the archive is damaged, or if the archive needs the
  /// 64-bit extension.
  /// \param most_bytes  all that file() gives may together have this size
  ZipArchive(const Source& source, std::uint64_t most_bytes);

  /// The bytes of a file; nullopt if there is none of that name. Throws IoError if they are damaged,
  /// encrypted, packed by another method than deflate, or more than what is left of `most_bytes`. Memory is
  /// allocated only for sizes that the packed bytes can hold.
  std::optional<std::string> file(const std::string& name);

 private:
  struct Entry {
    std::uint16_t flags, method;
    std::uint32_t checksum, packed_bytes, bytes, offset;
  };
  std::string_view part(std::uint64_t offset, std::uint64_t count) const;

  const Source& source_;
  std::uint64_t room_;
  std::map<std::string, Entry> entries_;
};

}  // namespace foramen::io_detail
