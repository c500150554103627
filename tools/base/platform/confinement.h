// Takes from this process what reading a shader or a model does not need, for good: what a crafted file makes
// of a mistake in a compiler or an importer ends here.
//
// POSIX: no core files, no file larger than kLargestConfinedFile. Linux, besides: a limit of memory
// (RLIMIT_DATA), no new privileges (PR_SET_NO_NEW_PRIVS), and where the program was built with libseccomp
// only the system calls that system_call_filter.cpp lists. Windows: nothing.
#pragma once

#include <cstddef>

namespace penumbra::platform {

inline constexpr std::size_t kLargestConfinedFile = std::size_t{64} << 20;  // bytes

// Closes what was inherited, from this descriptor on: a parent's files are not all closed at exec.
void close_descriptors_from(int first);

// The system ends this process with SIGXCPU after so many seconds of processor time from now.
void limit_processor_time(unsigned long long seconds);

// `memory`: bytes that may be allocated, and some for libraries; builds with sanitizers have no such limit.
// Call it before anything untrusted is read; what needs more, a graphics driver for example, is opened
// before. Threads that run already are confined too. Throws EnvironmentError where the kernel refuses the
// list of system calls, unless the environment variable PENUMBRA_UNFILTERED_WORKERS is 1: then only that is
// left out.
void confine_process(std::size_t memory);

}  // namespace penumbra::platform
