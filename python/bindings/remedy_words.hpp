#pragma once
/// \file
/// What Python calls its keywords and functions for the remedies of errors and notes.

#include <string>

#include "foramen/core/remedy.hpp"

namespace foramen::python {

/// The message with the keywords after it: "... has no such label; it holds 20-22 (labels)".
std::string worded(const Message& message);

}  // namespace foramen::python
