#pragma once
/// \file
/// The program's version.

#include <string>

namespace foramen {

/// "major.minor.patch".
std::string version();

/// The version, and a hash of the running program's file where the system shows it: two builds of one version
/// need not give the same bits.
std::string program_identity();

}  // namespace foramen
