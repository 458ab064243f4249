#include "modelfiles/version.hpp"

#include "foramen/core/error.hpp"
#include "io/sha256.hpp"

namespace foramen {

std::string version() { return FORAMEN_VERSION; }

std::string program_identity() {
  static const std::string identity = [] {
    try {
      return version() + " " + sha256_of_file("/proc/self/exe");
    } catch (const IoError&) {
      return version();
    }
  }();
  return identity;
}

}  // namespace foramen
