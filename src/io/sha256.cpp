#include "io/sha256.hpp"

#include <sha2.h>

#include <fstream>
#include <vector>

#include "foramen/core/error.hpp"

namespace foramen {

struct Sha256::State {
  SHA2_CTX context;
};

Sha256::Sha256() : state_(std::make_unique<State>()) { SHA256Init(&state_->context); }

Sha256::~Sha256() = default;

Sha256& Sha256::update(std::string_view bytes) {
  SHA256Update(&state_->context, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  return *this;
}

std::string Sha256::hex() const {
  SHA2_CTX last = state_->context;  // a copy, because SHA256End() erases its argument
  std::string digits(SHA256_DIGEST_STRING_LENGTH - 1, '0');
  SHA256End(&last,
            digits.data());  // also writes the final NUL, for which a std::string has room
  return digits;
}

std::string sha256(std::string_view bytes) { return Sha256().update(bytes).hex(); }

std::string sha256_of_file(const std::filesystem::path& path) {
  std::error_code ignored;
  std::ifstream in(path, std::ios::binary);
  if (!in || !std::filesystem::is_regular_file(path, ignored))
    throw IoError(path.string() + ": cannot be opened; check the name and the permissions");
  Sha256 hash;
  std::vector<char> buffer(1 << 16);
  while (in) {
    in.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    hash.update({buffer.data(), static_cast<std::size_t>(in.gcount())});
  }
  if (in.bad()) throw IoError(path.string() + ": cannot be read to its end; check the disk");
  return hash.hex();
}

}  // namespace foramen
