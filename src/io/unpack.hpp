#pragma once
/// \file
/// Private to io: the bytes of a file, unpacked on the way where they are compressed.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>

namespace foramen::io_detail {

/// Reads from a byte of a file on; a gzip or zlib stream that begins there is unpacked. Takes no memory that
/// depends on the file.
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
  /// A compressed stream does not end as it should (cut off, or another checksum than its bytes have), as far
  /// as it has been read.
  bool damaged() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace foramen::io_detail
