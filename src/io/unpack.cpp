#include "io/unpack.hpp"

#include "io/file_bytes.hpp"

#ifdef FORAMEN_WITH_ITK
#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <vector>

namespace foramen::io_detail {
namespace {

constexpr std::size_t chunk = std::size_t{1} << 18U;

struct Inflater {
  Inflater() {
    constexpr int gzip_or_zlib = 15 + 32;
    ready = inflateInit2(&stream, gzip_or_zlib) == Z_OK;
  }
  ~Inflater() { inflateEnd(&stream); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  z_stream stream{};
  bool ready = false;
};

}  // namespace

std::string first_bytes(const std::filesystem::path& path, std::size_t count) {
  require_readable(path);
  std::string bytes(count, '\0');
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  if (!file) Source{path.string(), {}}.refuse("cannot be opened", "check the permissions");
  const int got = gzread(file.get(), bytes.data(), static_cast<unsigned>(count));
  bytes.resize(static_cast<std::size_t>(std::max(got, 0)));
  return bytes;
}

UnpackedSize unpacked_size(const std::filesystem::path& path, std::int64_t offset, std::int64_t limit) {
  std::ifstream in(path, std::ios::binary);
  in.seekg(offset);
  Inflater inflater;
  UnpackedSize size;
  if (!in || !inflater.ready) return size;
  std::vector<char> packed(chunk), unpacked(chunk);
  constexpr int first_gzip_byte = 0x1f;
  z_stream& z = inflater.stream;
  bool ended = false;  // a stream; gzip files may have several
  while (size.bytes <= limit + static_cast<std::int64_t>(chunk)) {
    if (z.avail_in == 0) {
      in.read(packed.data(), static_cast<std::streamsize>(packed.size()));
      z.next_in = reinterpret_cast<Bytef*>(packed.data());
      z.avail_in = static_cast<uInt>(in.gcount());
    }
    size.intact = ended;
    if (z.avail_in == 0 || (ended && *z.next_in != first_gzip_byte)) return size;
    if (ended) inflateReset(&z);
    z.next_out = reinterpret_cast<Bytef*>(unpacked.data());
    z.avail_out = static_cast<uInt>(unpacked.size());
    const int outcome = inflate(&z, Z_NO_FLUSH);
    size.bytes += static_cast<std::int64_t>(unpacked.size() - z.avail_out);
    ended = outcome == Z_STREAM_END;
    if (!ended && outcome != Z_OK && outcome != Z_BUF_ERROR) return size;
  }
  size.intact = true;
  return size;
}

}  // namespace foramen::io_detail
#endif
