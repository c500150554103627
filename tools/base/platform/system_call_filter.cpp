// The list names allowed calls, not refused ones: calls of later kernels are refused until they are listed.
#include "platform/system_call_filter.h"

#include <asm/ioctls.h>
#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <memory>

namespace penumbra::platform {
namespace {

// These calls are allowed with any arguments: memory, threads, time, reading, existing descriptors, and what
// an open graphics driver does with them. Names that an architecture lacks are skipped.
constexpr const char* kAllowed[] = {
    // These calls concern memory.
    "brk", "madvise", "membarrier", "mincore", "mlock", "mprotect", "mremap", "munlock", "munmap",
    // These calls concern threads of this process.
    "arch_prctl", "exit", "exit_group", "futex", "futex_time64", "futex_waitv", "get_robust_list", "getcpu",
    "getpid", "getppid", "gettid", "restart_syscall", "rseq", "sched_getaffinity", "sched_getparam",
    "sched_getscheduler", "sched_yield", "set_robust_list", "set_tid_address",
    // These calls concern the process's own signals.
    "rt_sigaction", "rt_sigpending", "rt_sigprocmask", "rt_sigreturn", "rt_sigsuspend", "rt_sigtimedwait",
    "rt_sigtimedwait_time64", "sigaltstack", "sigreturn",
    // These calls concern time.
    "clock_getres", "clock_getres_time64", "clock_gettime", "clock_gettime64", "clock_nanosleep",
    "clock_nanosleep_time64", "gettimeofday", "nanosleep", "time", "times",
    // These calls read files.
    "_llseek", "access", "faccessat", "faccessat2", "fadvise64", "fadvise64_64", "fstat", "fstat64",
    "fstatat64", "fstatfs", "fstatfs64", "getcwd", "getdents", "getdents64", "lseek", "lstat", "lstat64",
    "newfstatat", "pread64", "preadv", "preadv2", "read", "readlink", "readlinkat", "readv", "stat", "stat64",
    "statfs", "statfs64", "statx",
    // These calls concern descriptors: none is open for writing but the connection to the parent and pipes.
    "close", "close_range", "dup", "dup2", "dup3", "epoll_create1", "epoll_ctl", "epoll_pwait", "epoll_wait",
    "eventfd2", "pipe", "pipe2", "poll", "ppoll", "ppoll_time64", "pselect6", "pselect6_time64", "select",
    "write", "writev",
    // These calls report facts.
    "getegid", "getegid32", "geteuid", "geteuid32", "getgid", "getgid32", "getrandom", "getrlimit",
    "getrusage", "getuid", "getuid32", "setrlimit", "sysinfo", "ugetrlimit", "uname"};

// These calls are refused in a foreign program, which has to run on calls that are not listed here.
constexpr const char* kForeign[] = {"acct",
                                    "add_key",
                                    "bpf",
                                    "chroot",
                                    "delete_module",
                                    "finit_module",
                                    "fsconfig",
                                    "fsmount",
                                    "fsopen",
                                    "init_module",
                                    "io_uring_setup",
                                    "kcmp",
                                    "kexec_file_load",
                                    "kexec_load",
                                    "keyctl",
                                    "mount",
                                    "mount_setattr",
                                    "move_mount",
                                    "open_by_handle_at",
                                    "open_tree",
                                    "perf_event_open",
                                    "pidfd_getfd",
                                    "pivot_root",
                                    "process_madvise",
                                    "process_vm_readv",
                                    "process_vm_writev",
                                    "ptrace",
                                    "quotactl",
                                    "reboot",
                                    "request_key",
                                    "setns",
                                    "swapoff",
                                    "swapon",
                                    "umount2",
                                    "unshare",
                                    "userfaultfd"};

class Filter {
 public:
  explicit Filter(std::uint32_t others = SCMP_ACT_ERRNO(EPERM))
      : context_(seccomp_init(others), seccomp_release) {
    if (!context_) error_ = ENOMEM;
  }

  template <typename... Comparisons>
  void rule(std::uint32_t action, const char* name, Comparisons... comparisons) {
    const int number = seccomp_syscall_resolve_name(name);
    if (error_ != 0 || number == __NR_SCMP_ERROR) return;  // this architecture has no call of that name
    const int result =
        seccomp_rule_add(context_.get(), action, number, sizeof...(comparisons), comparisons...);
    if (result != 0) error_ = -result;
  }
  template <typename... Comparisons>
  void allow(const char* name, Comparisons... comparisons) {
    rule(SCMP_ACT_ALLOW, name, comparisons...);
  }

  int load() {
    if (error_ != 0) return error_;
    // Running threads are filtered, too.
    if (const int result = seccomp_attr_set(context_.get(), SCMP_FLTATR_CTL_TSYNC, 1); result != 0)
      return -result;
    return -seccomp_load(context_.get());
  }

 private:
  std::unique_ptr<void, void (*)(scmp_filter_ctx)> context_;
  int error_ = 0;
};

void allow_reading(Filter& filter) {
  constexpr scmp_datum_t changing = O_ACCMODE | O_CREAT | O_TRUNC | O_PATH;
  filter.allow("open", SCMP_A1(SCMP_CMP_MASKED_EQ, changing, O_RDONLY));
  filter.allow("openat", SCMP_A2(SCMP_CMP_MASKED_EQ, changing, O_RDONLY));
}

// Allows memory of this process, and maps of open files. Files in memory and shared anonymous memory are not
// allowed: once they are unmapped, no limit of a process counts them.
void allow_memory(Filter& filter) {
  for (const char* name : {"mmap", "mmap2"}) {
    filter.allow(name, SCMP_A3(SCMP_CMP_MASKED_EQ, MAP_TYPE, MAP_PRIVATE));
    filter.allow(name, SCMP_A3(SCMP_CMP_MASKED_EQ, MAP_ANONYMOUS, 0));
  }
}

// A process may start threads but no new process. A C library that tries clone3, whose arguments a filter
// cannot see, falls back to clone.
void allow_threads(Filter& filter) {
  filter.allow("clone", SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, CLONE_THREAD));
  filter.rule(SCMP_ACT_ERRNO(ENOSYS), "clone3");
}

void allow_for_itself(Filter& filter) {
  const auto own = static_cast<scmp_datum_t>(::getpid());
  filter.allow("kill", SCMP_A0(SCMP_CMP_EQ, own));
  filter.allow("tgkill", SCMP_A0(SCMP_CMP_EQ, own));
  filter.allow("prlimit64", SCMP_A0(SCMP_CMP_EQ, 0));
  filter.allow("prctl", SCMP_A0(SCMP_CMP_EQ, PR_SET_NAME));
  filter.allow("prctl", SCMP_A0(SCMP_CMP_EQ, PR_GET_NAME));
#ifdef PR_SET_VMA
  filter.allow("prctl", SCMP_A0(SCMP_CMP_EQ, PR_SET_VMA));  // the call that names memory
#endif
}

void allow_on_descriptors(Filter& filter) {
  for (const int command : {F_DUPFD, F_DUPFD_CLOEXEC, F_GETFD, F_SETFD, F_GETFL, F_SETFL})
    for (const char* name : {"fcntl", "fcntl64"})
      filter.allow(name, SCMP_A1(SCMP_CMP_EQ, static_cast<scmp_datum_t>(command)));
  filter.allow("ioctl", SCMP_A1(SCMP_CMP_EQ, TCGETS));  // isatty()
  filter.allow("ioctl", SCMP_A1(SCMP_CMP_EQ, FIONREAD));
  for (const char driver : {'d', 'F'})  // direct rendering, and NVIDIA's own
    filter.allow("ioctl", SCMP_A1(SCMP_CMP_MASKED_EQ, 0xFF00, static_cast<scmp_datum_t>(driver) << 8U));
}

}  // namespace

int filter_system_calls() {
  Filter filter;
  for (const char* name : kAllowed) filter.allow(name);
  allow_memory(filter);
  allow_reading(filter);
  allow_threads(filter);
  allow_for_itself(filter);
  allow_on_descriptors(filter);
  return filter.load();
}

int filter_foreign_calls() {
  Filter filter(SCMP_ACT_ALLOW);
  for (const char* name : kForeign) filter.rule(SCMP_ACT_ERRNO(EPERM), name);
  filter.rule(SCMP_ACT_ERRNO(EAFNOSUPPORT), "socket", SCMP_A0(SCMP_CMP_NE, AF_UNIX));
  return filter.load();
}

}  // namespace penumbra::platform
