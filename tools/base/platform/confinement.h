// Irrevocably drops privileges of this process that reading a shader or a model does not need, so that an
// exploited bug in a compiler or an importer is contained.
//
// POSIX: no core files, no file larger than kLargestConfinedFile. Linux also: a memory limit (RLIMIT_DATA),
// no new privileges (PR_SET_NO_NEW_PRIVS), and, if built with libseccomp, only the system calls that
// system_call_filter.cpp lists. Windows: nothing.
#pragma once

#include <cstddef>

namespace penumbra::platform {

inline constexpr std::size_t kLargestConfinedFile = std::size_t{64} << 20;  // bytes

// Closes inherited descriptors from this one on: exec does not close all of a parent's files.
void close_descriptors_from(int first);

// The system ends this process with SIGXCPU after that many seconds of CPU time from now.
void limit_processor_time(unsigned long long seconds);

// Sets the limits of confine_process() alone, for a process that becomes another program.
void limit_resources(std::size_t memory);

// `memory` is the number of bytes that may be allocated, with some more for libraries; builds with sanitizers
// have no such limit. The function must be called before anything untrusted is read; anything that needs more
// privileges, such as a graphics driver, is opened before. Running threads are confined, too. Throws
// EnvironmentError if the kernel refuses the system call filter, unless the environment variable
// PENUMBRA_UNFILTERED_WORKERS is 1: then only the filter is omitted.
void confine_process(std::size_t memory);

}  // namespace penumbra::platform
