// A pool of worker processes for work that may crash, hang or exhaust memory: a failing worker affects only
// the message that it processes.
//
// A worker is this program in a hidden mode: it only calls serve_worker(). Messages and responses use a
// socket of their own, which the output of compilers does not disturb. Every message has limits: CPU time
// (independent of the machine's load), elapsed time (for work that waits), memory, and the size of its
// response. A failed worker is replaced. Workers end with their parent process, however that ends, and drop
// the privileges that they do not need (platform/confinement.h): they read files, and change none.
//
// The memory limit applies to resident pages, which the parent polls (every 10 ms) on systems with /proc,
// that is, on Linux; faster growth ends at RLIMIT_DATA, a little above. Threads are polled, too. Memory that
// would be in neither number, because it is shared, cannot be allocated (platform/system_call_filter.cpp).
//
// A worker has only the variables of its parent's environment that its libraries read
// (worker_process.cpp), and cannot read its parent's memory.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra::platform {

struct WorkerLimits {
  std::chrono::seconds processor_time{30};      // limit for one message
  std::chrono::milliseconds time{180'000};      // limit for one message
  std::size_t memory = std::size_t{2} << 30;    // bytes of a worker
  std::size_t answer = std::size_t{256} << 20;  // bytes of one answer, question or note
};

inline constexpr std::size_t kMostWorkerThreads = 512;  // a driver has one for each processor, and a few

struct WorkerMessage {
  std::size_t number = 0;  // identifies this message in all callbacks
  std::string content;
};

struct WorkerOutcome {
  std::string answer;   // the handler's result; empty if it failed
  std::string failure;  // why there is no result: "crashed with SIGSEGV", a limit; empty on success
  bool from_outside =
      false;         // the worker was killed externally (SIGKILL, SIGTERM): the message need not be the cause
  std::string note;  // the handler's last note before it failed
  std::string output_tail;  // the end of what a failed worker printed
};

// The interface that supplies a pool with work. Calls are serialised: from the thread that runs the pool, or,
// without processes, from its threads in turn.
class WorkSource {
 public:
  virtual ~WorkSource() = default;
  // Returns the next message for this worker, from 0: its earlier work may help it (caches). Returns nothing
  // if there is nothing to hand out now; the pool asks again after every finished().
  virtual std::optional<WorkerMessage> next(unsigned worker) = 0;
  virtual std::string answer_question(std::size_t number, const std::string& question) = 0;
  virtual void finished(std::size_t number, WorkerOutcome outcome) = 0;
};

// The handler's connection to the pool's user while it works.
class WorkerLink {
 public:
  virtual ~WorkerLink() = default;
  virtual std::string ask(std::string_view question) = 0;
  virtual void note(std::string_view text) = 0;  // kept for the outcome if the worker fails after it
};

// Thrown by a handler whose own helper process has ended, so that the worker cannot process another message:
// the message fails with this text, as if the worker had, and the worker is replaced.
class WorkerSpent : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

using WorkHandler = std::function<std::string(const std::string& message, WorkerLink& link)>;

struct WorkerPool {
  std::vector<std::string> arguments;  // the arguments that start this program as a worker
  unsigned workers = 1;
  WorkerLimits limits;
};

bool worker_processes_supported();  // true for POSIX

// Runs until next() returns nothing and every message is finished. Throws EnvironmentError if no worker can
// be started or a handler throws one, Interrupted if the user interrupts; in either case all workers have
// ended. Call it from a thread that lives until it returns.
void run_workers(const WorkerPool& pool, WorkSource& source);

// Processes one message. Throws as run_workers() does. `pool.workers` is ignored: there is one.
WorkerOutcome ask_worker(const WorkerPool& pool, std::string message);

// Does the same without processes: it starts faster, but has no isolation. Throws what a handler throws.
void run_in_threads(unsigned threads, const WorkHandler& handler, WorkSource& source);

// Runs the worker's side: processes messages until the parent closes its end. An exception of the handler is
// a failure of that message; an EnvironmentError ends the whole run. `prepare` is called before the process
// is confined, with the pool's limits, for anything that needs more than reading, such as opening a graphics
// driver. Returns the exit code of the process.
int serve_worker(const WorkHandler& handler, const std::function<void(const WorkerLimits&)>& prepare = {});

}  // namespace penumbra::platform
