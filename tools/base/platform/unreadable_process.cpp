#include "platform/unreadable_process.h"

#ifdef __linux__
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <mutex>
#endif

namespace penumbra::platform {

#ifdef __linux__
namespace {

std::mutex counting;
int living = 0;
int before = 1;  // state of the process before the first object

}  // namespace

UnreadableProcess::UnreadableProcess() {
  const std::lock_guard<std::mutex> lock(counting);
  if (living++ > 0) return;
  before = ::prctl(PR_GET_DUMPABLE, 0, 0, 0, 0);
  ::prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);
}

UnreadableProcess::~UnreadableProcess() {
  const std::lock_guard<std::mutex> lock(counting);
  if (--living == 0) ::prctl(PR_SET_DUMPABLE, before, 0, 0, 0);
}

void give_up_reading_processes() {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct sets[_LINUX_CAPABILITY_U32S_3]{};
  if (::syscall(SYS_capget, &header, sets) != 0) return;
  constexpr int kPerfmon = 38;  // CAP_PERFMON, which older headers do not name
  for (const int right : {CAP_SYS_PTRACE, CAP_SYS_ADMIN, kPerfmon}) {
    __user_cap_data_struct& set = sets[right / 32];
    const unsigned kept = ~(1U << static_cast<unsigned>(right % 32));
    set.effective &= kept;
    set.permitted &= kept;
    set.inheritable &= kept;
  }
  ::syscall(SYS_capset, &header, sets);
}

#else

UnreadableProcess::UnreadableProcess() = default;
UnreadableProcess::~UnreadableProcess() = default;

void give_up_reading_processes() {}

#endif

}  // namespace penumbra::platform
