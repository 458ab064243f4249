#include "foramen/pipeline/version.hpp"

namespace foramen {

std::string version() { return FORAMEN_VERSION; }

}  // namespace foramen
