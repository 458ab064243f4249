#pragma once
/// \file
/// Memory that was freed and is still the process's.

namespace foramen {

/// Gives it back to the system where the C library can (glibc); changes nothing else. For the end of a stage:
/// what the next one takes is laid out otherwise, and the allocator keeps the holes between what still lives.
void return_freed_memory();

}  // namespace foramen
