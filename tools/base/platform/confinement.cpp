#include "platform/confinement.h"

#ifndef _WIN32
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string_view>
#endif
#ifdef __linux__
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

#include "input/input_error.h"
#include "platform/system_call_filter.h"

namespace penumbra::platform {

#ifndef _WIN32
namespace {

// This is added to the limit that a pool monitors: memory that libraries and thread stacks reserve without
// using it.
[[maybe_unused]] constexpr std::size_t kReservedMemory = std::size_t{512} << 20;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
[[maybe_unused]] constexpr bool kSanitized = true;  // sanitizers reserve terabytes
#else
[[maybe_unused]] constexpr bool kSanitized = false;
#endif

void lower_limit(int resource, rlim_t to) {
  rlimit limit{};
  ::getrlimit(resource, &limit);
  limit.rlim_max = std::min(limit.rlim_max, to);
  limit.rlim_cur = std::min(limit.rlim_cur, limit.rlim_max);
  ::setrlimit(resource, &limit);
}

bool filter_is_unwanted() {
  const char* wish = std::getenv("PENUMBRA_UNFILTERED_WORKERS");  // NOLINT(concurrency-mt-unsafe)
  return wish != nullptr && std::string_view(wish) == "1";
}

}  // namespace

void close_descriptors_from(int first) {
#if defined(__linux__) && defined(SYS_close_range)
  if (::syscall(SYS_close_range, static_cast<unsigned>(first), ~0U, 0U) == 0) return;
#endif
  const long end = std::min(::sysconf(_SC_OPEN_MAX), 65536L);
  for (int descriptor = first; descriptor < end; ++descriptor) ::close(descriptor);
}

void limit_processor_time(unsigned long long seconds) {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  rlimit limit{};
  ::getrlimit(RLIMIT_CPU, &limit);
  const auto used = static_cast<rlim_t>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec);
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, used + seconds + 1);
  ::setrlimit(RLIMIT_CPU, &limit);
}

void limit_resources([[maybe_unused]] std::size_t memory) {
  lower_limit(RLIMIT_CORE, 0);
  lower_limit(RLIMIT_FSIZE, kLargestConfinedFile);
  ::signal(SIGXFSZ, SIG_IGN);  // a write that is too large fails instead
#ifdef __linux__
  if (!kSanitized) lower_limit(RLIMIT_DATA, memory + kReservedMemory);
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
#endif
}

void confine_process(std::size_t memory) {
  limit_resources(memory);
  if (filter_is_unwanted()) return;
  if (const int error = filter_system_calls(); error != 0)
    throw EnvironmentError(
        std::string("this kernel does not let a worker process filter its system calls (seccomp): ") +
        std::strerror(error) +
        "\n  for files that you trust, set the environment variable "
        "PENUMBRA_UNFILTERED_WORKERS to 1");
}

#else

void close_descriptors_from(int) {}

void limit_processor_time(unsigned long long) {}

void limit_resources(std::size_t) {}

void confine_process(std::size_t) {}

#endif

}  // namespace penumbra::platform
