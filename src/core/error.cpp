#include "foramen/core/error.hpp"

#include <string>

namespace foramen {

Message message_of(const std::exception& error) {
  const auto* ours = dynamic_cast<const Error*>(&error);
  return {error.what(), ours != nullptr ? ours->remedies() : std::vector<Remedy>()};
}

namespace detail {

void assertion_failed(const char* condition, const char* file, int line) {
  const std::string path = file;
  const std::string name = path.substr(path.find_last_of('/') + 1);
  throw InternalError("internal error (please report it): " + std::string(condition) + " does not hold at " +
                      name + ":" + std::to_string(line));
}

}  // namespace detail
}  // namespace foramen
