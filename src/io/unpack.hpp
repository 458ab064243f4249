#pragma once
/// \file
/// Private to io: the bytes of a file, decompressed while they are read.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace foramen::io_detail {

/// Reads a file from a byte offset and decompresses a gzip or zlib stream that begins there. The memory that
/// it needs does not depend on the file.
class ByteStream {
 public:
  enum class Packing { none, deflate };
  /// Throws IoError if the file cannot be opened.
  ByteStream(const std::filesystem::path& path, std::int64_t offset, Packing packing);
  ~ByteStream();
  ByteStream(const ByteStream&) = delete;
  ByteStream& operator=(const ByteStream&) = delete;

  /// The next bytes, at most `count`; fewer at the end, and where a compressed stream is damaged.
  std::size_t read(char* out, std::size_t count);
  /// Whether the part of a compressed stream that was read so far is truncated or has a wrong checksum.
  bool damaged() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The whole file as read_bytes() gives it, decompressed if its first bytes are those of gzip. Refuses a file
/// that is damaged or has more than 2 GiB after decompression.
std::string unpacked_bytes(const std::filesystem::path& path);

}  // namespace foramen::io_detail
