#pragma once
/// \file
/// What the program calls its flags and commands for the remedies of errors and notes.

#include "foramen/core/error.hpp"

namespace foramen::app {

/// The message with the flags after it: "...: the file is probably in cm, give this unit (--units cm)".
std::string worded(const Message& message);

/// The same of an error.
std::string worded(const std::exception& error);

}  // namespace foramen::app
