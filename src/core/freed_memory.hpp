#pragma once
/// \file
/// Returns freed memory to the operating system.

namespace foramen {

/// Returns the memory that the allocator holds in reserve to the operating system, if the C library can do so
/// (glibc). Called at the end of a stage, because the next stage allocates blocks of other sizes and cannot
/// use the gaps that the allocator would otherwise keep.
void return_freed_memory();

}  // namespace foramen
