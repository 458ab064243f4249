#pragma once
/// \file
/// How much memory is in use, for tests of what is held and what is let go of.

#include <malloc.h>

namespace foramen::testing {

/// Bytes of the heap in use now, of all threads. 0 under sanitizers, whose heap is their own: a test that
/// compares two readings passes there.
inline double heap_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

}  // namespace foramen::testing
