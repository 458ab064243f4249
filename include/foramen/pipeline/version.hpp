#pragma once
/// \file
/// The program's version.

#include <string>

namespace foramen {

/// "major.minor.patch".
std::string version();

}  // namespace foramen
