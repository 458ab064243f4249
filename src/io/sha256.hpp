#pragma once
/// \file
/// SHA-256 (FIPS 180-4): names inputs and finished stages by their content.

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace foramen {

/// A hash over bytes that come in pieces; how they are cut does not matter.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256& update(std::string_view bytes);
  /// 64 lower-case hexadecimal digits. Leaves this object as it is, so that more may follow.
  std::string hex() const;

 private:
  struct State;  // libmd's, kept out of this header so that those who include it need not have libmd's
  std::unique_ptr<State> state_;
};

std::string sha256(std::string_view bytes);
/// Throws IoError if the file cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace foramen
