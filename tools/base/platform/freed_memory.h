// What becomes of memory that the program has freed.
#pragma once

namespace penumbra::platform {

// Keeps freed memory for later allocations. By its own rule glibc gives large blocks back to the system at
// once, which has to clear their pages anew when they are asked for again: compilers and the software device
// allocate and free megabytes thousands of times. Without glibc nothing happens.
void keep_freed_memory();

}  // namespace penumbra::platform
