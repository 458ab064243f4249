#include "io/unpack.hpp"

#include <zlib.h>

#include <fstream>
#include <limits>
#include <vector>

#include "foramen/core/error.hpp"
#include "io/file_bytes.hpp"

namespace foramen::io_detail {

struct ByteStream::State {
  std::ifstream file;
  Packing packing = Packing::none;
  z_stream inflater{};
  std::vector<char> packed;
  bool ended = false, damaged = false;

  ~State() {
    if (packing == Packing::deflate) inflateEnd(&inflater);
  }

  void refill() {
    if (inflater.avail_in > 0) return;
    file.read(packed.data(), static_cast<std::streamsize>(packed.size()));
    inflater.next_in = reinterpret_cast<Bytef*>(packed.data());
    inflater.avail_in = static_cast<uInt>(file.gcount());
  }
  // Several streams may follow each other in a gzip file. Anything else after a stream is ignored.
  bool next_stream() {
    constexpr int first_gzip_byte = 0x1f;
    if (inflater.avail_in == 0 || *inflater.next_in != first_gzip_byte) return false;
    inflateReset(&inflater);
    ended = false;
    return true;
  }
};

ByteStream::ByteStream(const std::filesystem::path& path, std::int64_t offset, Packing packing)
    : state_(std::make_unique<State>()) {
  state_->file.open(path, std::ios::binary);
  if (!state_->file) Source{path.string(), {}}.refuse("cannot be opened", "check the permissions");
  state_->file.seekg(offset);
  if (packing == Packing::none) return;
  constexpr int gzip_or_zlib = 15 + 32;
  constexpr std::size_t buffer = std::size_t{1} << 18U;
  FORAMEN_ASSERT(inflateInit2(&state_->inflater, gzip_or_zlib) == Z_OK);
  state_->packing = packing;
  state_->packed.resize(buffer);
}

ByteStream::~ByteStream() = default;

std::size_t ByteStream::read(char* out, std::size_t count) {
  State& s = *state_;
  if (s.packing == Packing::none) {
    s.file.read(out, static_cast<std::streamsize>(count));
    return s.file.gcount();
  }
  FORAMEN_ASSERT(count <= std::numeric_limits<uInt>::max());
  s.inflater.next_out = reinterpret_cast<Bytef*>(out);
  s.inflater.avail_out = static_cast<uInt>(count);
  while (s.inflater.avail_out > 0 && !s.damaged) {
    s.refill();
    if (s.ended && !s.next_stream()) break;
    const int outcome = s.inflater.avail_in == 0 ? Z_DATA_ERROR : inflate(&s.inflater, Z_NO_FLUSH);
    s.ended = outcome == Z_STREAM_END;
    s.damaged = !s.ended && outcome != Z_OK && outcome != Z_BUF_ERROR;
  }
  return count - s.inflater.avail_out;
}

bool ByteStream::damaged() const { return state_->damaged; }

std::string unpacked_bytes(const std::filesystem::path& path) {
  std::string bytes = read_bytes(path);
  if (!bytes.starts_with("\x1f\x8b")) return bytes;
  const Source source{path.string(), {}};
  bytes.clear();
  constexpr std::size_t most = std::size_t{1} << 31U, step = std::size_t{1} << 20U;
  ByteStream stream(path, 0, ByteStream::Packing::deflate);
  for (bool more = true; more;) {
    const std::size_t at = bytes.size();
    bytes.resize(at + step);
    bytes.resize(at + stream.read(bytes.data() + at, step));
    more = bytes.size() == at + step;
    if (bytes.size() > most)
      source.refuse("has more than 2 GiB when it is decompressed", "decompress it and simplify the surface");
  }
  if (stream.damaged()) source.refuse("its compressed data are damaged or cut off", remedy_export_again);
  if (bytes.empty()) source.refuse("is empty when it is decompressed", remedy_export_again);
  return bytes;
}

}  // namespace foramen::io_detail
