#pragma once
/// \file
/// The exceptions that foramen throws. The type says whether the file, the data, the method or foramen itself
/// is at fault; the message says what was found and what to do about it.

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "foramen/core/remedy.hpp"

namespace foramen {

/// Base of all errors that a caller may want to show to a user.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& text, std::vector<Remedy> remedies = {})
      : std::runtime_error(text), remedies_(std::move(remedies)) {}
  explicit Error(const Message& message) : Error(message.text, message.remedies) {}
  /// What a front end can name a control for; the text says the same without it.
  const std::vector<Remedy>& remedies() const { return remedies_; }

 private:
  std::vector<Remedy> remedies_;
};

/// A file cannot be opened, read or written, or breaks its own format.
class IoError : public Error {
  using Error::Error;
};

/// The data is well-formed but cannot be used (indices out of range, wrong units, NaN, too few shapes ...).
class InvalidInput : public Error {
  using Error::Error;
};

/// A surface whose topology is not what the operation needs (open, non-manifold, genus other than 1 ...).
class TopologyError : public InvalidInput {
  using InvalidInput::InvalidInput;
};

/// A numerical method stopped without a reliable result.
class ConvergenceError : public Error {
  using Error::Error;
};

/// The user asked to stop. This is not a failure.
class Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled") {}
};

/// An internal invariant of foramen does not hold: always a defect of foramen, never the user's fault.
class InternalError : public std::logic_error {
  using std::logic_error::logic_error;
};

/// What an error says, with its remedies if it has any.
Message message_of(const std::exception& error);

namespace detail {
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);
}

}  // namespace foramen

/// Checks an internal invariant in debug and release builds alike; throws InternalError if it does not hold.
#define FORAMEN_ASSERT(condition) \
  ((condition) ? void(0) : ::foramen::detail::assertion_failed(#condition, __FILE__, __LINE__))
