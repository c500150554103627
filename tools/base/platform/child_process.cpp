#include "platform/child_process.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string_view>
#include <thread>

#include "input/input_error.h"
#include "platform/interrupt.h"

#ifndef _WIN32
#include <signal.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;  // NOLINT(readability-redundant-declaration): not every system declares it
#endif

namespace penumbra::platform {

#ifndef _WIN32
const int signal_of_processor_time = SIGXCPU;

namespace {

// The three streams are anonymous temporary files, not pipes: no pipe can fill up and block either side, and
// a grandchild that outlives the child cannot keep us waiting for the end of a stream.
class TemporaryStream {
 public:
  TemporaryStream() : file_(std::tmpfile()) {
    if (file_ == nullptr) {
      throw EnvironmentError(std::string("a temporary file cannot be created: ") + std::strerror(errno));
    }
  }
  ~TemporaryStream() { std::fclose(file_); }
  TemporaryStream(const TemporaryStream&) = delete;
  TemporaryStream& operator=(const TemporaryStream&) = delete;

  int descriptor() const { return ::fileno(file_); }

  void fill(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), file_) != text.size() || std::fflush(file_) != 0) {
      throw EnvironmentError(std::string("a temporary file cannot be written: ") + std::strerror(errno));
    }
    std::rewind(file_);
  }

  std::size_t size() const {
    struct stat status {};
    return ::fstat(descriptor(), &status) == 0 ? static_cast<std::size_t>(status.st_size) : 0;
  }

  std::string content() {
    std::string text(size(), '\0');
    std::rewind(file_);
    text.resize(std::fread(text.data(), 1, text.size(), file_));
    return text;
  }

 private:
  std::FILE* file_;
};

struct Streams {
  TemporaryStream input;
  TemporaryStream output;
  TemporaryStream errors;
};

class ChildSettings {
 public:
  explicit ChildSettings(const Streams& streams) {
    posix_spawn_file_actions_init(&actions);
    const int descriptors[] = {streams.input.descriptor(), streams.output.descriptor(),
                               streams.errors.descriptor()};
    for (int target = 0; target < 3; ++target) {
      posix_spawn_file_actions_adddup2(&actions, descriptors[target], target);
    }
    for (const int descriptor : descriptors) posix_spawn_file_actions_addclose(&actions, descriptor);
    // The child has a process group of its own, so that a timeout also ends the processes that it started.
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);
  }
  ~ChildSettings() {
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
  }
  ChildSettings(const ChildSettings&) = delete;
  ChildSettings& operator=(const ChildSettings&) = delete;

  posix_spawn_file_actions_t actions{};
  posix_spawnattr_t attributes{};
};

// Returns NAME=VALUE of every variable that the child sees.
std::vector<std::string> variables_of(const ChildCommand& command) {
  std::vector<std::string> variables;
  for (char** at = environ; *at != nullptr; ++at) {
    const std::string_view variable = *at;
    const std::string_view name = variable.substr(0, variable.find('='));
    const bool replaced = std::any_of(command.environment.begin(), command.environment.end(),
                                      [name](const auto& given) { return given.first == name; });
    if (!replaced) variables.emplace_back(variable);
  }
  for (const auto& [name, value] : command.environment)
    variables.emplace_back(name).append("=").append(value);
  return variables;
}

// Returns a list of strings as the system expects it: pointers, the last one null.
std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

pid_t start(const ChildCommand& command, const Streams& streams) {
  std::vector<std::string> words{command.program};
  words.insert(words.end(), command.arguments.begin(), command.arguments.end());
  const std::vector<char*> argv = pointers_to(words);
  std::vector<std::string> variables = variables_of(command);
  const std::vector<char*> environment = pointers_to(variables);

  const ChildSettings settings(streams);
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, argv[0], &settings.actions, &settings.attributes, argv.data(),
                                   environment.data());
  if (error != 0) {
    throw EnvironmentError("'" + command.program + "' cannot be started: " + std::strerror(error));
  }
  return child;
}

int end_group(pid_t child) {
  ::kill(-child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

ChildResult run_child(const ChildCommand& command) {
  Streams streams;
  streams.input.fill(command.input);
  const auto deadline = std::chrono::steady_clock::now() + command.timeout;
  const pid_t child = start(command, streams);

  ChildResult result;
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    result.timed_out = std::chrono::steady_clock::now() >= deadline;
    result.overflowed = streams.output.size() + streams.errors.size() > command.output_limit;
    const bool stop = interrupted();
    if (result.timed_out || result.overflowed || stop) {
      status = end_group(child);
      if (stop) throw Interrupted();
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  result.exit_code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  result.output = streams.output.content();
  result.errors = streams.errors.content();
  return result;
}

#else

const int signal_of_processor_time = 0;

ChildResult run_child(const ChildCommand& command) {
  throw EnvironmentError("'" + command.program +
                         "' cannot be started: child processes are supported on POSIX systems only");
}

#endif

std::optional<std::filesystem::path> find_program(const std::string& name) {
  const char* path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe)
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path candidate = std::filesystem::path(folder) / name;
    std::error_code error;
    const auto status = std::filesystem::status(candidate, error);
    const auto runnable = std::filesystem::perms::owner_exec | std::filesystem::perms::others_exec;
    if (std::filesystem::is_regular_file(status) &&
        (status.permissions() & runnable) != std::filesystem::perms::none) {
      return candidate;
    }
  }
  return std::nullopt;
}

}  // namespace penumbra::platform
