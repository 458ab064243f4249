#pragma once
/// \file
/// Private to io: blocks of bytes whose size is known, as VTK and zip archives compress them.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace foramen::io_detail {

/// `deflate` is zlib without header and checksum.
enum class BlockPacking { zlib, deflate, lz4, lzma };

/// More bytes than this cannot come out of a block of that size.
std::uint64_t most_unpacked(BlockPacking packing, std::uint64_t packed_bytes);

/// The decompressed bytes; nullopt if the block is damaged or holds another number of bytes than `size`.
/// \pre size <= most_unpacked()
std::optional<std::string> unpack_block(BlockPacking packing, std::string_view block, std::size_t size);

}  // namespace foramen::io_detail
