// Work that may crash, hang or eat all memory, done in processes of its own: a worker that goes wrong takes
// one message with it, and nothing else.
//
// A worker is this same program in a hidden mode: it calls serve_worker() and nothing else. Messages go to it
// and answers come back over a socket of their own, so that what a compiler prints disturbs neither. Every
// message has limits: processor time (a verdict that does not depend on what else the machine does), time
// that passes (for what waits instead of computing), memory, and the size of its answer. A worker that fails
// is replaced. Workers end with the process that started them, however that ends, and give up what their work
// does not need (platform/confinement.h): they read files, and change none.
//
// The memory limit is on resident pages, which the parent watches (every 10 ms) where the system has /proc,
// that is, on Linux; what a worker takes faster than that ends at RLIMIT_DATA, a little above.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra::platform {

struct WorkerLimits {
  std::chrono::seconds processor_time{30};      // of one message
  std::chrono::milliseconds time{180'000};      // of one message
  std::size_t memory = std::size_t{2} << 30;    // bytes of a worker
  std::size_t answer = std::size_t{256} << 20;  // bytes of one answer, question or note
};

struct WorkerMessage {
  std::size_t number = 0;  // returned with everything that concerns this message
  std::string content;
};

struct WorkerOutcome {
  std::string answer;   // what the handler returned; empty when it failed
  std::string failure;  // why there is no answer: "crashed with SIGSEGV", a limit; empty when there is one
  bool from_outside =
      false;                // somebody else ended the worker (SIGKILL, SIGTERM): the message may be innocent
  std::string note;         // the last that the handler noted before it failed
  std::string output_tail;  // the end of what a failed worker printed
};

// What a pool asks of its user. All calls come one at a time: from the thread that runs the pool, or, without
// processes, from its threads in turn.
class WorkSource {
 public:
  virtual ~WorkSource() = default;
  // For this worker of the pool, from 0: what it has done before may help it. Nothing when there is nothing
  // to hand out now; the pool asks again after every finished().
  virtual std::optional<WorkerMessage> next(unsigned worker) = 0;
  virtual std::string answer_question(std::size_t number, const std::string& question) = 0;
  virtual void finished(std::size_t number, WorkerOutcome outcome) = 0;
};

// The handler's way back to the pool's user while it works.
class WorkerLink {
 public:
  virtual ~WorkerLink() = default;
  virtual std::string ask(std::string_view question) = 0;
  virtual void note(std::string_view text) = 0;  // kept for the outcome, should this be the last
};

using WorkHandler = std::function<std::string(const std::string& message, WorkerLink& link)>;

struct WorkerPool {
  std::vector<std::string> arguments;  // that start this program as a worker
  unsigned workers = 1;
  WorkerLimits limits;
};

bool worker_processes_supported();  // POSIX

// Until next() gives nothing and every message is finished. Throws EnvironmentError when no worker can be
// started or a handler throws one, Interrupted when the user stops us; either way no worker is left. Call it
// from a thread that lives until it returns.
void run_workers(const WorkerPool& pool, WorkSource& source);

// One message: what became of it. Throws as run_workers() does. `pool.workers` is 1 whatever it says.
WorkerOutcome ask_worker(const WorkerPool& pool, std::string message);

// The same work without processes: quicker to start, and at the mercy of every message. Throws what a handler
// throws.
void run_in_threads(unsigned threads, const WorkHandler& handler, WorkSource& source);

// The worker's side: answers messages until the parent closes its end. An exception of the handler is a
// failure of that message; an EnvironmentError ends the whole run. `prepare` is called before the process is
// confined, for what needs more than reading: opening a graphics driver. Returns the exit code of the
// process.
int serve_worker(const WorkHandler& handler, const std::function<void()>& prepare = {});

}  // namespace penumbra::platform
