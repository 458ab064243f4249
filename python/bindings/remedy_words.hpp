#pragma once
/// \file
/// What Python calls its keywords and functions for the remedies of errors and notes.

#include <string>
#include <vector>

#include "foramen/core/remedy.hpp"

namespace foramen::python {

/// The message with the keywords after it: "... has no such label; it holds 20-22 (labels)".
std::string worded(const Message& message);

/// Issues each note as a UserWarning of the line that called the package's function. Needs the interpreter's
/// lock. Throws if the user turned warnings into errors.
void warn(const std::vector<Message>& notes);

}  // namespace foramen::python
