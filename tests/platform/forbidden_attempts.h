// Code that has taken over a worker would try these.
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <thread>

namespace penumbra::platform {

// The outcome: "done", or the error's name.
inline std::string outcome_of(long result) {
  return result >= 0 ? "done" : ::strerrorname_np(errno);
}

inline long fork_and_wait() {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  if (child > 0) ::waitpid(child, nullptr, 0);
  return child;
}

inline long vfork_and_wait() {
  const pid_t child = ::vfork();
  if (child == 0) ::_exit(0);
  return child;
}

// Opens a file as io_uring and openat2 do: their arguments lie where a filter cannot look.
inline long open_by_structure(const std::string& file) {
  struct {
    unsigned long long flags, mode, resolve;
  } how{O_WRONLY | O_CREAT, 0600, 0};
  return ::syscall(SYS_openat2, AT_FDCWD, file.c_str(), &how, sizeof how);
}

inline long run_other_program() {
  char* const arguments[] = {const_cast<char*>("true"), nullptr};
  return ::execve("/bin/true", arguments, nullptr);
}

inline long run_memory() {
  const int program = ::memfd_create("program", 0);
  char* const none[] = {nullptr};
  return ::syscall(SYS_execveat, program, "", none, none, AT_EMPTY_PATH);
}

inline long fill_memory_file(std::size_t bytes) {
  const int file = ::memfd_create("large", 0);
  const long result = ::ftruncate(file, static_cast<off_t>(bytes));
  const int error = errno;
  ::close(file);
  errno = error;
  return result;
}

inline long share_memory(int flags) {
  void* memory = ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE, flags, -1, 0);
  return memory == MAP_FAILED ? -1 : 0;
}

// Reads a file of the parent's folder in /proc, which says what it holds only to those that may trace the
// parent.
inline long read_of_parent(const std::string& file) {
  const std::string name = "/proc/" + std::to_string(::getppid()) + "/" + file;
  const int opened = ::open(name.c_str(), O_RDONLY);
  char first = 0;
  return opened < 0 ? -1 : ::read(opened, &first, file == "mem" ? 0 : 1);
}

inline long read_parents_memory() {
  char byte = 0;
  iovec here{&byte, 1};
  iovec there{reinterpret_cast<void*>(&read_parents_memory), 1};
  return ::process_vm_readv(::getppid(), &here, 1, &there, 1, 0);
}

inline std::string environment() {
  std::string names;
  for (char** at = environ; *at != nullptr; ++at)
    names += " " + std::string(*at).substr(0, std::string(*at).find('='));
  return names;
}

inline long start_a_thread() {
  std::thread([] {}).join();
  return 0;
}

inline long allocate_too_much() {
  std::string memory;
  memory.reserve(std::size_t{64} << 30U);
  return static_cast<long>(memory.capacity());
}

inline std::string descriptors() {
  std::string names;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd"))
    if (std::filesystem::exists(std::filesystem::read_symlink(entry.path())) &&
        entry.path().filename() != "0")
      names += " " + std::filesystem::read_symlink(entry.path()).string();
  return names;
}

inline std::string own_status(const std::string& field) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(field + ":")) return line.substr(line.find('\t') + 1);
  return "";
}

// Makes an attempt and returns its outcome, as text. `what` is a name of the table, for some with a file
// behind ": ".
inline std::string attempt(const std::string& what) {
  const std::string name = what.substr(0, what.find(": "));
  const std::string file = name == what ? std::string() : what.substr(name.size() + 2);
  const std::map<std::string, std::function<long()>> attempts{
      {"a socket", [] { return ::socket(AF_INET, SOCK_STREAM, 0); }},
      {"a socket of this machine", [] { return ::socket(AF_UNIX, SOCK_STREAM, 0); }},
      {"to connect", [] { return ::connect(3, nullptr, 0); }},
      {"to send", [] { return ::send(3, "x", 1, 0); }},
      {"another program", run_other_program},
      {"a program in memory", run_memory},
      {"to fork", fork_and_wait},
      {"to vfork", vfork_and_wait},
      {"to trace", [] { return ::ptrace(PTRACE_ATTACH, ::getppid(), nullptr, nullptr); }},
      {"to read its parent", read_parents_memory},
      {"to read of its parent", [&] { return read_of_parent(file); }},
      {"to signal its parent", [] { return ::kill(::getppid(), 0); }},
      {"io_uring", [] { return ::syscall(SYS_io_uring_setup, 1, nullptr); }},
      {"to create", [&] { return ::open(file.c_str(), O_WRONLY | O_CREAT, 0600); }},
      {"to create for reading", [&] { return ::open(file.c_str(), O_RDONLY | O_CREAT, 0600); }},
      {"to create nameless", [&] { return ::open(file.c_str(), O_RDWR | O_TMPFILE, 0600); }},
      {"to create as before", [&] { return ::syscall(SYS_creat, file.c_str(), 0600); }},
      {"to create by structure", [&] { return open_by_structure(file); }},
      {"to write", [&] { return ::open(file.c_str(), O_WRONLY); }},
      {"to append", [&] { return ::open(file.c_str(), O_RDWR | O_APPEND); }},
      {"to cut", [&] { return ::open(file.c_str(), O_RDONLY | O_TRUNC); }},
      {"to truncate", [&] { return ::truncate(file.c_str(), 0); }},
      {"to remove", [&] { return ::unlink(file.c_str()); }},
      {"to rename", [&] { return ::rename(file.c_str(), (file + "2").c_str()); }},
      {"to link", [&] { return ::symlink("/etc/passwd", (file + "2").c_str()); }},
      {"a folder", [&] { return ::mkdir((file + "2").c_str(), 0700); }},
      {"to change the mode", [&] { return ::chmod(file.c_str(), 0777); }},
      {"another priority", [] { return ::syscall(SYS_setpriority, 0, ::getppid(), 5); }},
      {"to change its parent's limits",
       [] { return ::syscall(SYS_prlimit64, ::getppid(), 7, nullptr, nullptr); }},
      {"a large file", [] { return fill_memory_file(std::size_t{65} << 20U); }},
      {"a small file", [] { return fill_memory_file(std::size_t{63} << 20U); }},
      {"a file in memory", [] { return ::memfd_create("file", 0); }},
      {"shared memory", [] { return share_memory(MAP_SHARED | MAP_ANONYMOUS); }},
      {"shared memory, validated", [] { return share_memory(MAP_SHARED_VALIDATE | MAP_ANONYMOUS); }},
      {"private memory", [] { return share_memory(MAP_PRIVATE | MAP_ANONYMOUS); }},
      {"a segment", [] { return ::shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0600); }},
      {"to read", [&] { return ::open(file.c_str(), O_RDONLY); }},
      {"a thread", start_a_thread},
      {"to allocate 64 GiB", allocate_too_much},
  };
  if (name == "own status") return own_status(file);
  if (name == "descriptors") return descriptors();
  if (name == "environment") return environment();
  const auto found =
      attempts.find(name.starts_with("to ") || attempts.count(name) != 0 ? name : "to " + name);
  if (found == attempts.end()) return "unknown attempt";
  return outcome_of(found->second());
}

}  // namespace penumbra::platform
