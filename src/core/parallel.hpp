#pragma once
/// \file
/// Loops over independent items. Results must be written per item; any reduction is done afterwards, in
/// order, so that the number of threads never changes a bit of the result.

#include <functional>

#include "foramen/core/run_context.hpp"

namespace foramen {

/// Calls body(0) .. body(count-1), in any order, on at most ctx.threads() threads. Checks for cancellation
/// between items. If bodies throw, the exception of the smallest such index that ran is thrown on; others may
/// not run.
void parallel_for(int count, const RunContext& ctx, const std::function<void(int)>& body);

}  // namespace foramen
