#include "platform/worker_pool.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "input/input_error.h"
#include "platform/interrupt.h"
#include "platform/terminal.h"
#include "platform/worker_process.h"

#ifndef _WIN32
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#endif

namespace penumbra::platform {

#ifndef _WIN32
namespace {

using Clock = std::chrono::steady_clock;

// The interval at which running messages are checked: memory, time, Ctrl-C.
constexpr std::chrono::milliseconds watch_interval{10};
// A worker that takes longer than this to report that it is ready has failed.
constexpr std::chrono::seconds start_limit{60};

std::string signal_name(int number) {
  switch (number) {
    case SIGSEGV:
      return "SIGSEGV";
    case SIGABRT:
      return "SIGABRT";
    case SIGBUS:
      return "SIGBUS";
    case SIGFPE:
      return "SIGFPE";
    case SIGILL:
      return "SIGILL";
    case SIGTRAP:
      return "SIGTRAP";
    case SIGSYS:
      return "SIGSYS";
    case SIGKILL:
      return "SIGKILL";
    case SIGTERM:
      return "SIGTERM";
    default:
      return "signal " + std::to_string(number);
  }
}

std::string seconds_text(std::chrono::milliseconds time) {
  const auto count = time.count();
  return count % 1000 == 0 ? std::to_string(count / 1000) + " s" : std::to_string(count) + " ms";
}

// The text is in the form that serve_worker() reads.
std::string settings_text(const WorkerLimits& limits) {
  return std::to_string(limits.processor_time.count()) + " " + std::to_string(limits.memory) + " " +
         std::to_string(limits.answer);
}

// A worker and the message that it processes.
class WorkerSlot {
 public:
  WorkerSlot(const WorkerPool& pool, WorkSource& source) : pool_(pool), source_(source) {}

  bool busy() const { return busy_; }
  bool started() const { return process_ != nullptr; }
  const WorkerProcess& process() const { return *process_; }

  void hand_out(const WorkerMessage& message) {
    if (!process_) start();
    busy_ = true;
    number_ = message.number;
    outcome_ = {};
    since_ = Clock::now();
    process_->send(FrameKind::message, message.content);
  }

  void read(bool frames, bool output) {
    if (output) process_->read_child_output();
    if (!frames) return;
    const bool lives = process_->read_frames();
    while (process_) {
      std::optional<Frame> frame = process_->next_frame();
      if (!frame) break;
      take(*std::move(frame));
    }
    if (!lives && process_) ended();
  }

  void write() { process_->send_more(); }

  void watch() {
    if (!process_) return;
    const auto spent = Clock::now() - since_;
    if (!ready_ && spent > start_limit) throw EnvironmentError("a worker process did not start in time");
    if (!busy_ || spent < watch_interval) return;
    if (spent > pool_.limits.time) return fail("took longer than " + seconds_text(pool_.limits.time));
    if (process_->resident_bytes() > pool_.limits.memory) return fail(too_much_memory(pool_.limits.memory));
    if (process_->threads() > kMostWorkerThreads)
      fail("started more than " + std::to_string(kMostWorkerThreads) + " threads");
  }

 private:
  void start() {
    process_ = std::make_unique<WorkerProcess>(pool_.arguments, pool_.limits.answer);
    ready_ = false;
    process_->send(FrameKind::settings, settings_text(pool_.limits));
  }

  void take(Frame frame) {
    switch (frame.kind) {
      case FrameKind::ready:
        ready_ = true;
        since_ = Clock::now();
        return;
      case FrameKind::question:
        return process_->send(FrameKind::reply, source_.answer_question(number_, frame.content));
      case FrameKind::note:
        outcome_.note = std::move(frame.content);
        return;
      case FrameKind::answer:
        outcome_.answer = std::move(frame.content);
        outcome_.note.clear();
        return finish();
      case FrameKind::failure:
        outcome_.failure = std::move(frame.content);
        return finish();
      case FrameKind::spent:
        return fail(std::move(frame.content));
      case FrameKind::environment:
        throw EnvironmentError(frame.content);
      case FrameKind::settings:
      case FrameKind::message:
      case FrameKind::reply:
        return fail("sent a malformed message");  // frames of the other direction: memory was overwritten
    }
    fail("sent a malformed message");
  }

  // The worker has closed its end unexpectedly.
  void ended() {
    const int status = process_->end();
    if (!ready_) {
      throw EnvironmentError("a worker process ended before it was ready; its output:\n" +
                             process_->output_tail());
    }
    if (!busy_) {  // It ended between two messages, so no waiting message is the cause.
      process_.reset();
      return;
    }
    if (!WIFSIGNALED(status)) return fail("ended with exit code " + std::to_string(WEXITSTATUS(status)));
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU)
      return fail("took more than " + seconds_text(pool_.limits.processor_time) + " of CPU time");
    outcome_.from_outside = signal == SIGKILL || signal == SIGTERM || signal == SIGHUP || signal == SIGINT;
    fail((outcome_.from_outside ? "was killed externally by " : "crashed with ") + signal_name(signal));
  }

  void fail(std::string reason) {
    process_->end();
    outcome_.failure = std::move(reason);
    outcome_.output_tail = process_->output_tail();
    process_.reset();
    finish();
  }

  void finish() {
    busy_ = false;
    // Memory leaks of compilers accumulate: a worker that has grown is replaced before a message exceeds the
    // limit because of it.
    if (process_ && process_->resident_bytes() > pool_.limits.memory / 2) process_.reset();
    source_.finished(number_, std::exchange(outcome_, {}));
  }

  const WorkerPool& pool_;
  WorkSource& source_;
  std::unique_ptr<WorkerProcess> process_;
  bool ready_ = false;
  bool busy_ = false;
  std::size_t number_ = 0;
  WorkerOutcome outcome_;
  Clock::time_point since_;
};

// Waits until something can be read or written, or the next check is due.
void serve_slots(std::vector<WorkerSlot>& slots) {
  std::vector<pollfd> waiting;
  std::vector<WorkerSlot*> owners;
  for (WorkerSlot& slot : slots) {
    if (!slot.started()) continue;
    const short events = slot.process().has_more_to_send() ? POLLIN | POLLOUT : POLLIN;
    waiting.push_back({slot.process().socket(), events, 0});
    waiting.push_back({slot.process().child_output(), POLLIN, 0});
    owners.push_back(&slot);
  }
  ::poll(waiting.data(), static_cast<nfds_t>(waiting.size()), static_cast<int>(watch_interval.count()));
  for (std::size_t i = 0; i < owners.size(); ++i) {
    const short socket = waiting[2 * i].revents;
    if ((socket & POLLOUT) != 0) owners[i]->write();
    owners[i]->read((socket & ~POLLOUT) != 0, (waiting[2 * i + 1].revents & POLLIN) != 0);
    owners[i]->watch();
  }
}

class OneMessage final : public WorkSource {
 public:
  explicit OneMessage(std::string content) : message_({0, std::move(content)}) {}

  std::optional<WorkerMessage> next(unsigned) override { return std::exchange(message_, std::nullopt); }
  std::string answer_question(std::size_t, const std::string&) override { return {}; }
  void finished(std::size_t, WorkerOutcome of_it) override { outcome = std::move(of_it); }

  WorkerOutcome outcome;

 private:
  std::optional<WorkerMessage> message_;
};

}  // namespace

bool worker_processes_supported() {
  return !program_path().empty();
}

WorkerOutcome ask_worker(const WorkerPool& pool, std::string message) {
  OneMessage source(std::move(message));
  run_workers({pool.arguments, 1, pool.limits}, source);
  return std::move(source.outcome);
}

void run_workers(const WorkerPool& pool, WorkSource& source) {
  std::vector<WorkerSlot> slots;
  slots.reserve(pool.workers + 1);
  for (unsigned i = 0; i < std::max(1U, pool.workers); ++i) slots.emplace_back(pool, source);
  for (;;) {
    throw_if_interrupted();
    bool busy = false;
    for (std::size_t i = 0; i < slots.size(); ++i) {
      if (!slots[i].busy())
        if (std::optional<WorkerMessage> message = source.next(static_cast<unsigned>(i)))
          slots[i].hand_out(*std::move(message));
      busy = busy || slots[i].busy();
    }
    if (!busy) return;
    serve_slots(slots);
  }
}

#else

bool worker_processes_supported() {
  return false;
}

void run_workers(const WorkerPool&, WorkSource&) {
  throw EnvironmentError("worker processes are supported on POSIX systems only");
}

WorkerOutcome ask_worker(const WorkerPool&, std::string) {
  throw EnvironmentError("worker processes are supported on POSIX systems only");
}

#endif

}  // namespace penumbra::platform
