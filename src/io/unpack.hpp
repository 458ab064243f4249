#pragma once
/// \file
/// Private to io: gzip and zlib streams in files.

#include <cstdint>
#include <filesystem>
#include <string>

namespace foramen::io_detail {

/// The first bytes of a file, at most `count`; unpacked if it is a gzip file. Throws IoError if it is no
/// regular file, empty or cannot be read.
std::string first_bytes(const std::filesystem::path& path, std::size_t count);

struct UnpackedSize {
  std::int64_t bytes = 0;
  bool intact = false;  ///< ends as such a stream should, with the right checksum; or goes on beyond the limit
};

/// How many bytes the gzip or zlib stream from `offset` to the end of the file unpacks to, counted a little
/// beyond `limit` at most. Takes no memory that depends on the file.
UnpackedSize unpacked_size(const std::filesystem::path& path, std::int64_t offset, std::int64_t limit);

}  // namespace foramen::io_detail
