#include "platform/worker_process.h"

#ifndef _WIN32

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
#include <utility>

#include "input/input_error.h"
#include "platform/terminal.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): not every system declares it

namespace penumbra::platform {
namespace {

constexpr std::string_view kNames[] = {
    // The program itself reads these.
    "PENUMBRA_FXC", "PENUMBRA_ROOT", "PENUMBRA_UNFILTERED_WORKERS",
    // These say where libraries, programs and packages lie.
    "HOME", "LD_LIBRARY_PATH", "NUGET_PACKAGES", "PATH", "TMPDIR", "XDG_CACHE_HOME",
    // Builds with sanitizers read these.
    "ASAN_OPTIONS", "LSAN_OPTIONS", "TSAN_OPTIONS", "UBSAN_OPTIONS"};

// Graphics drivers have dozens of variables each, which begin like this.
constexpr std::string_view kBeginnings[] = {"EGL_", "GALLIUM_", "LIBGL_", "LP_", "MESA_", "__EGL_"};

bool is_needed(std::string_view name) {
  return std::ranges::find(kNames, name) != std::end(kNames) ||
         std::ranges::any_of(kBeginnings, [name](std::string_view start) { return name.starts_with(start); });
}

// Returns NAME=VALUE of each variable of this process that a worker or its graphics driver reads, and of no
// other.
std::vector<std::string> worker_environment() {
  std::vector<std::string> variables;
  for (char** at = environ; *at != nullptr; ++at) {
    const std::string_view variable = *at;
    if (is_needed(variable.substr(0, variable.find('=')))) variables.emplace_back(variable);
  }
  return variables;
}

constexpr std::size_t output_tail_bytes = 2048;
// The most that is read at a time: a worker that writes endlessly must not block the parent.
constexpr int most_reads = 256;

#ifdef MSG_NOSIGNAL
constexpr int no_signal = MSG_NOSIGNAL;
#else
constexpr int no_signal = 0;
#endif

[[noreturn]] void fail(const char* what) {
  throw EnvironmentError(std::string("a worker process cannot be started: ") + what + ": " +
                         std::strerror(errno));
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return number_; }
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

// The descriptor is above the numbers that a worker's own descriptors get, and is closed in every other
// child.
int out_of_the_way(int descriptor) {
  const Descriptor original(descriptor);
  const int copy = ::fcntl(descriptor, F_DUPFD_CLOEXEC, worker_frames_descriptor + 1);
  if (copy < 0) fail("too many open files");
  return copy;
}

struct Ends {
  explicit Ends(const int (&pair)[2]) : ours(out_of_the_way(pair[0])), theirs(out_of_the_way(pair[1])) {
    ::fcntl(ours.get(), F_SETFL, O_NONBLOCK);
  }
  Descriptor ours;
  Descriptor theirs;
};

std::unique_ptr<Ends> socket_ends() {
  int pair[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM, 0, pair) != 0) fail("no socket");
#ifdef SO_NOSIGPIPE
  const int on = 1;
  ::setsockopt(pair[0], SOL_SOCKET, SO_NOSIGPIPE, &on, sizeof on);
#endif
  return std::make_unique<Ends>(pair);
}

std::unique_ptr<Ends> pipe_ends() {
  int pair[2];
  if (::pipe(pair) != 0) fail("no pipe");
  return std::make_unique<Ends>(pair);
}

// The worker's descriptors: nothing to read on 0, its other output on 1 and 2, the frames on 3.
class WorkerSettings {
 public:
  WorkerSettings(int frames, int noise) {
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, noise, 1);
    posix_spawn_file_actions_adddup2(&actions, noise, 2);
    posix_spawn_file_actions_adddup2(&actions, frames, worker_frames_descriptor);
    posix_spawnattr_init(&attributes);
    // The worker has a process group of its own: the pool handles Ctrl-C at the terminal, and the worker's
    // children end with it.
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    posix_spawnattr_setpgroup(&attributes, 0);
    sigset_t every;
    sigfillset(&every);
    posix_spawnattr_setsigdefault(&attributes, &every);
  }
  ~WorkerSettings() {
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
  }
  WorkerSettings(const WorkerSettings&) = delete;
  WorkerSettings& operator=(const WorkerSettings&) = delete;

  posix_spawn_file_actions_t actions{};
  posix_spawnattr_t attributes{};
};

// Returns pointers to the texts, with a null pointer at the end, as the system takes them.
std::vector<char*> argument_pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  list.reserve(texts.size() + 1);
  for (std::string& text : texts) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

}  // namespace

WorkerProcess::WorkerProcess(const std::vector<std::string>& arguments, std::size_t largest_answer)
    : reader_(largest_answer) {
  const std::unique_ptr<Ends> frames = socket_ends();
  const std::unique_ptr<Ends> noise = pipe_ends();
  std::vector<std::string> words{program_path().string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = worker_environment();
  const std::vector<char*> argv = argument_pointers(words);
  const std::vector<char*> environment = argument_pointers(variables);
  const WorkerSettings settings(frames->theirs.get(), noise->theirs.get());
  errno = ::posix_spawn(&process_, argv[0], &settings.actions, &settings.attributes, argv.data(),
                        environment.data());
  if (errno != 0) fail(argv[0]);
  socket_ = frames->ours.release();
  child_output_ = noise->ours.release();
}

WorkerProcess::~WorkerProcess() {
  end();
  ::close(socket_);
  ::close(child_output_);
}

void WorkerProcess::send(FrameKind kind, std::string_view content) {
  outbox_ += frame_bytes(kind, content);
  send_more();
}

void WorkerProcess::send_more() {
  while (!outbox_.empty()) {
    const ssize_t sent = ::send(socket_, outbox_.data(), outbox_.size(), no_signal);
    if (sent > 0) {
      outbox_.erase(0, static_cast<std::size_t>(sent));
    } else if (errno == EPIPE || errno == ECONNRESET) {
      outbox_.clear();  // it has ended; the next read reports it
    } else if (errno != EINTR) {
      return;
    }
  }
}

bool WorkerProcess::read_frames() {
  char buffer[65536];
  for (int reads = 0; reads < most_reads; ++reads) {
    const ssize_t count = ::read(socket_, buffer, sizeof buffer);
    if (count > 0) {
      reader_.add(buffer, static_cast<std::size_t>(count));
    } else if (count == 0 || (errno != EINTR && errno != EAGAIN && errno != EWOULDBLOCK)) {
      return false;
    } else if (errno != EINTR) {
      return true;
    }
  }
  return true;
}

void WorkerProcess::read_child_output() {
  char buffer[4096];
  ssize_t count = 0;
  for (int reads = 0; reads < most_reads && (count = ::read(child_output_, buffer, sizeof buffer)) > 0;
       ++reads) {
    output_tail_.append(buffer, static_cast<std::size_t>(count));
    if (output_tail_.size() > output_tail_bytes)
      output_tail_.erase(0, output_tail_.size() - output_tail_bytes);
  }
}

std::string WorkerProcess::fact(const char* file) const {
  char name[64];
  std::snprintf(name, sizeof name, "/proc/%d/%s", static_cast<int>(process_), file);
  const Descriptor opened(::open(name, O_RDONLY | O_CLOEXEC));
  char text[1024];
  const ssize_t count = opened.get() < 0 ? 0 : ::read(opened.get(), text, sizeof text);
  return {text, static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
}

std::size_t WorkerProcess::resident_bytes() const {
  unsigned long pages = 0;
  if (std::sscanf(fact("statm").c_str(), "%*u %lu", &pages) != 1) return 0;
  return static_cast<std::size_t>(pages) * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

// The fields stand behind the program's name, which may hold anything: the state is the third field, the
// threads are the twentieth.
std::size_t WorkerProcess::threads() const {
  const std::string facts = fact("stat");
  const std::size_t name_end = facts.rfind(')');
  unsigned long count = 0;
  if (name_end == std::string::npos ||
      std::sscanf(facts.c_str() + name_end + 1,
                  " %*c %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %lu", &count) != 1)
    return 0;
  return count;
}

int WorkerProcess::end() {
  if (status_) return *status_;
  ::kill(-process_, SIGKILL);
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  read_child_output();
  status_ = status;
  return status;
}

}  // namespace penumbra::platform

#endif
