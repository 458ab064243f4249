#include "io/unpack_block.hpp"

#include <lz4.h>
#include <lzma.h>
#include <zlib.h>

#include <limits>
#include <utility>

namespace foramen::io_detail {
namespace {

bool inflate_zlib(std::string_view block, std::string& out) {
  uLongf length = out.size();
  return uncompress(reinterpret_cast<Bytef*>(out.data()), &length,
                    reinterpret_cast<const Bytef*>(block.data()), block.size()) == Z_OK &&
         length == out.size();
}

bool inflate_raw(std::string_view block, std::string& out) {
  constexpr std::size_t most = std::numeric_limits<uInt>::max();
  constexpr int without_header = -15;
  z_stream stream{};
  if (block.size() > most || out.size() > most || inflateInit2(&stream, without_header) != Z_OK) return false;
  stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(block.data()));  // zlib only reads it
  stream.avail_in = static_cast<uInt>(block.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int outcome = inflate(&stream, Z_FINISH);
  inflateEnd(&stream);
  return outcome == Z_STREAM_END && stream.avail_out == 0;
}

bool inflate_lz4(std::string_view block, std::string& out) {
  constexpr std::size_t most = std::numeric_limits<int>::max();
  if (block.size() > most || out.size() > most) return false;
  return LZ4_decompress_safe(block.data(), out.data(), static_cast<int>(block.size()),
                             static_cast<int>(out.size())) == static_cast<int>(out.size());
}

bool inflate_lzma(std::string_view block, std::string& out) {
  std::uint64_t memory = std::uint64_t{256} << 20U;  // of the dictionary; VTK needs a fraction
  std::size_t read = 0, written = 0;
  return lzma_stream_buffer_decode(&memory, 0, nullptr, reinterpret_cast<const std::uint8_t*>(block.data()),
                                   &read, block.size(), reinterpret_cast<std::uint8_t*>(out.data()), &written,
                                   out.size()) == LZMA_OK &&
         written == out.size();
}

}  // namespace

std::uint64_t most_unpacked(BlockPacking packing, std::uint64_t packed_bytes) {
  // Deflate packs at most about 1032 bytes into one, LZ4 255. LZMA has no such bound: its blocks by VTK are
  // of 32 KiB by default, and a file of 100 bytes can hold one.
  constexpr std::uint64_t zlib = 1032, lz4 = 256, lzma = 8192;
  const std::uint64_t densest = packing == BlockPacking::lz4    ? lz4
                                : packing == BlockPacking::lzma ? lzma
                                                                : zlib;
  return densest * (packed_bytes + 1);
}

std::optional<std::string> unpack_block(BlockPacking packing, std::string_view block, std::size_t size) {
  std::string out(size, '\0');
  const bool whole = packing == BlockPacking::zlib      ? inflate_zlib(block, out)
                     : packing == BlockPacking::deflate ? inflate_raw(block, out)
                     : packing == BlockPacking::lz4     ? inflate_lz4(block, out)
                                                        : inflate_lzma(block, out);
  return whole ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace foramen::io_detail
