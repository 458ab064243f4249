#pragma once
/// \file
/// SHA-256 (FIPS 180-4), by which input files and the results of stages are identified.

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace foramen {

/// The hash of bytes that are added in pieces. It does not depend on where the pieces are divided.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256& update(std::string_view bytes);
  /// 64 lower-case hexadecimal digits for the bytes so far. More bytes may be added afterwards.
  std::string hex() const;

 private:
  struct State;  // hides the header of libmd from those who include this one
  std::unique_ptr<State> state_;
};

std::string sha256(std::string_view bytes);
/// Throws IoError if the file cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace foramen
