#pragma once
/// \file
/// SHA-256 (FIPS 180-4): names inputs and finished stages by their content.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace foramen {

/// A hash over bytes that come in pieces; how they are cut does not matter.
class Sha256 {
 public:
  Sha256& update(std::string_view bytes);
  /// 64 lower-case hexadecimal digits. Leaves this object as it is, so that more may follow.
  std::string hex() const;

 private:
  void block(const unsigned char* bytes);
  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, 64> pending_{};
  std::uint64_t length_ = 0;  // bytes seen
};

std::string sha256(std::string_view bytes);
/// Throws IoError if the file cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace foramen
