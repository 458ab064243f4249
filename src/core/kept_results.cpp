#include "core/kept_results.hpp"

#include "foramen/core/error.hpp"

namespace foramen::detail {

std::optional<KeptKind> kept_kind(const std::exception& error) {
  if (dynamic_cast<const TopologyError*>(&error) != nullptr) return KeptKind::topology_error;
  if (dynamic_cast<const InvalidInput*>(&error) != nullptr) return KeptKind::invalid_input;
  if (dynamic_cast<const ConvergenceError*>(&error) != nullptr) return KeptKind::convergence_error;
  return std::nullopt;
}

void throw_kept(KeptKind kind, const Message& message) {
  switch (kind) {
    case KeptKind::topology_error:
      throw TopologyError(message);
    case KeptKind::invalid_input:
      throw InvalidInput(message);
    case KeptKind::convergence_error:
      throw ConvergenceError(message);
    case KeptKind::result:
      break;
  }
  throw InternalError("a kept error has no kind");
}

}  // namespace foramen::detail
