#pragma once
/// \file
/// The amount of memory in use, for tests of memory that is kept or released.

#include <malloc.h>

namespace foramen::testing {

/// The bytes of the heap that all threads use now. The result is 0 with sanitizers, which have their own
/// heap, so a test that compares two results passes there.
inline double heap_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

}  // namespace foramen::testing
