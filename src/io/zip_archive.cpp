#include "io/zip_archive.hpp"

#include <zlib.h>

#include <algorithm>
#include <utility>

#include "io/unpack_block.hpp"

namespace foramen::io_detail {
namespace {

constexpr std::string_view local_mark("PK\3\4", 4), entry_mark("PK\1\2", 4), end_mark("PK\5\6", 4);
constexpr std::uint64_t local_size = 30, entry_size = 46, end_size = 22;

std::uint16_t number16(std::string_view bytes, std::size_t at) {
  return ByteCursor(bytes, at, ByteOrder::little).read<std::uint16_t>();
}
std::uint32_t number32(std::string_view bytes, std::size_t at) {
  return ByteCursor(bytes, at, ByteOrder::little).read<std::uint32_t>();
}

}  // namespace

bool is_zip(std::string_view bytes) { return bytes.starts_with(local_mark); }

std::string_view ZipArchive::part(std::uint64_t offset, std::uint64_t count) const {
  if (offset > source_.bytes.size() || count > source_.bytes.size() - offset)
    source_.refuse("is an archive that is cut off", remedy_export_again);
  return source_.bytes.substr(offset, count);
}

ZipArchive::ZipArchive(const Source& source, std::uint64_t most_bytes) : source_(source), room_(most_bytes) {
  const auto end = source.bytes.rfind(end_mark);  // a comment may follow the end record
  if (end == std::string_view::npos) source.refuse("is an archive that is cut off", remedy_export_again);
  const std::string_view record = part(end, end_size);
  const std::size_t count = number16(record, 10);
  std::uint64_t at = number32(record, 16);
  constexpr std::uint32_t in_zip64 = 0xffffffff;
  if (at == in_zip64) source.refuse("is an archive in 64-bit zip", "pack it again as plain zip");
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view head = part(at, entry_size);
    if (!head.starts_with(entry_mark))
      source.refuse("is an archive whose list of files is damaged", remedy_export_again);
    const std::uint64_t name_length = number16(head, 28);
    std::string name(part(at + entry_size, name_length));
    std::replace(name.begin(), name.end(), '\\', '/');  // as some programs for Windows write
    entries_.emplace(std::move(name), Entry{number16(head, 8), number16(head, 10), number32(head, 16),
                                            number32(head, 20), number32(head, 24), number32(head, 42)});
    at += entry_size + name_length + number16(head, 30) + number16(head, 32);
  }
}

std::optional<std::string> ZipArchive::file(const std::string& name) {
  const auto found = entries_.find(name);
  if (found == entries_.end()) return std::nullopt;
  const Entry& entry = found->second;
  const auto refuse = [&](const std::string& what, const char* remedy = remedy_export_again) {
    source_.refuse("its part " + in_quotes(name) + " " + what, remedy);
  };
  constexpr unsigned encrypted = 1, stored = 0, deflated = 8;
  if ((entry.flags & encrypted) != 0) refuse("is encrypted", "save it without a password");
  if (entry.method != stored && entry.method != deflated)
    refuse("is packed by method " + std::to_string(entry.method), "pack it again as plain zip");
  if (entry.bytes > room_) refuse("is too large when it is unpacked", "give a smaller file");
  const std::string_view head = part(entry.offset, local_size);
  if (!head.starts_with(local_mark)) refuse("is not where the list of files says");
  const std::string_view packed =
      part(entry.offset + local_size + number16(head, 26) + number16(head, 28), entry.packed_bytes);
  std::optional<std::string> bytes;
  if (entry.method == stored) {
    if (entry.packed_bytes == entry.bytes) bytes = std::string(packed);
  } else if (entry.bytes <= most_unpacked(BlockPacking::deflate, packed.size())) {
    bytes = unpack_block(BlockPacking::deflate, packed, entry.bytes);
  }
  if (!bytes || crc32(0, reinterpret_cast<const Bytef*>(bytes->data()), static_cast<uInt>(bytes->size())) !=
                    entry.checksum)
    refuse("is damaged");
  room_ -= bytes->size();
  return bytes;
}

}  // namespace foramen::io_detail
