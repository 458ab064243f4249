#pragma once
/// \file
/// Parallel loops over independent items. Each call of the body writes only the result of its own item, and
/// the caller reduces the results afterwards in order, so the result does not depend on the number of
/// threads.

#include <functional>

#include "foramen/core/run_context.hpp"

namespace foramen {

/// Calls body(0) .. body(count-1) in any order on at most ctx.threads() threads and checks for cancellation
/// between items. If a body throws, items that have not begun may be left out; of all exceptions thrown, the
/// one of the smallest index is rethrown.
void parallel_for(int count, const RunContext& ctx, const std::function<void(int)>& body);

}  // namespace foramen
