#pragma once
/// \file
/// The program's version.

#include <string>

namespace foramen {

/// The version as "major.minor.patch".
std::string version();

/// The version, and a hash of the running program's file if the system gives access to it. The hash is needed
/// because two builds of the same version may compute different bits.
std::string program_identity();

}  // namespace foramen
