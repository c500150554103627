#include "platform/confined_child.h"

#include "input/input_error.h"

#ifndef _WIN32
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <iterator>

#include "platform/confinement.h"
#include "platform/file_access.h"
#include "platform/system_call_filter.h"
#endif

namespace penumbra::platform {

#ifndef _WIN32
namespace {

// Returns pointers to the texts, with a null pointer at the end, as exec takes them.
std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  list.reserve(texts.size() + 1);
  for (std::string& text : texts) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

// The function runs in the child, after fork, and never returns to the parent's code.
[[noreturn]] void become(const ConfinedCommand& command, char* const* arguments, char* const* environment,
                         int input, int output) {
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  ::dup2(input, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  if (const int nothing = ::open("/dev/null", O_WRONLY); nothing >= 0) ::dup2(nothing, STDERR_FILENO);
  close_descriptors_from(STDERR_FILENO + 1);
  if (::chdir(command.directory.c_str()) != 0) ::_exit(EXIT_FAILURE);
  limit_resources(command.memory);
  allow_files(command.readable, command.writable);
  if (filter_foreign_calls() != 0) ::_exit(EXIT_FAILURE);
  ::execve(command.program.c_str(), arguments, environment);
  ::_exit(EXIT_FAILURE);
}

void make_pipe(int (&ends)[2]) {
  if (::pipe(ends) != 0) throw EnvironmentError(std::string("no pipe: ") + std::strerror(errno));
  for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
}

// Returns a descriptor that becomes readable when the process ends; -1 where there is no such thing.
int end_of(pid_t process) {
#ifdef __linux__
  return static_cast<int>(::syscall(SYS_pidfd_open, process, 0));
#else
  static_cast<void>(process);
  return -1;
#endif
}

// Returns whether the pipe's end can be read or written, which it also can when the other end is closed. A
// process that has ended writes no more, even if a process that it started, such as Wine's server, holds the
// other end open.
bool is_ready(int pipe, short event, std::chrono::milliseconds patience, int ended) {
  pollfd waited[] = {{pipe, event, 0}, {ended, POLLIN, 0}};
  const auto wait = [&waited](std::chrono::milliseconds most) {
    int ready = 0;
    do ready = ::poll(waited, std::size(waited), static_cast<int>(most.count()));
    while (ready < 0 && errno == EINTR);
    return ready > 0;
  };
  if (!wait(patience)) return false;
  if (waited[0].revents == 0) wait(std::chrono::milliseconds(0));
  return waited[0].revents != 0;
}

}  // namespace

ConfinedChild::ConfinedChild(const ConfinedCommand& command) : patience_(command.patience) {
  std::vector<std::string> words{command.program};
  words.insert(words.end(), command.arguments.begin(), command.arguments.end());
  std::vector<std::string> settings;
  for (const auto& [name, value] : command.environment) settings.push_back(name + "=" + value);
  const std::vector<char*> arguments = pointers(words);
  const std::vector<char*> environment = pointers(settings);
  int to_child[2];
  int from_child[2];
  make_pipe(to_child);
  make_pipe(from_child);
  process_ = ::fork();
  if (process_ == 0) become(command, arguments.data(), environment.data(), to_child[0], from_child[1]);
  const int problem = errno;
  ::close(to_child[0]);
  ::close(from_child[1]);
  input_ = to_child[1];
  output_ = from_child[0];
  ::fcntl(input_, F_SETFL, O_NONBLOCK);  // write() does the waiting
  if (process_ < 0)
    throw EnvironmentError("no process can be started: " + std::string(std::strerror(problem)));
  ended_ = end_of(process_);
  ::signal(SIGPIPE, SIG_IGN);  // write() reports that the child has ended
}

ConfinedChild::~ConfinedChild() {
  ::close(input_);
  ::close(output_);
  if (ended_ >= 0) ::close(ended_);
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

bool ConfinedChild::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(input_, bytes.data(), bytes.size());
    if (count > 0)
      bytes.remove_prefix(static_cast<std::size_t>(count));
    else if (errno == EAGAIN ? !is_ready(input_, POLLOUT, patience_, ended_) : errno != EINTR)
      return false;
  }
  return true;
}

bool ConfinedChild::read(char* bytes, std::size_t count) {
  while (count > 0) {
    if (!is_ready(output_, POLLIN, patience_, ended_)) return false;
    const ssize_t read = ::read(output_, bytes, count);
    if (read > 0) {
      bytes += read;
      count -= static_cast<std::size_t>(read);
    } else if (read == 0 || errno != EINTR) {
      return false;
    }
  }
  return true;
}

#else

ConfinedChild::ConfinedChild(const ConfinedCommand& command) {
  throw EnvironmentError("'" + command.program +
                         "' cannot be started: confined processes need a POSIX system");
}
ConfinedChild::~ConfinedChild() = default;
bool ConfinedChild::write(std::string_view) {
  return false;
}
bool ConfinedChild::read(char*, std::size_t) {
  return false;
}

#endif

}  // namespace penumbra::platform
