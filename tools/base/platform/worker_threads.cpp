#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <utility>

#include "platform/interrupt.h"
#include "platform/thread_group.h"
#include "platform/worker_pool.h"

namespace penumbra::platform {

namespace {

class ThreadsRun {
 public:
  ThreadsRun(const WorkHandler& handler, WorkSource& source) : handler_(handler), source_(source) {}

  void work() {
    const unsigned worker = workers_++;
    try {
      while (const std::optional<WorkerMessage> message = next(worker)) {
        throw_if_interrupted();
        Link link(*this, message->number);
        WorkerOutcome outcome;
        outcome.answer = handler_(message->content, link);
        const std::lock_guard<std::mutex> lock(mutex_);
        source_.finished(message->number, std::move(outcome));
        --at_work_;
        changed_.notify_all();
      }
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      --at_work_;
      changed_.notify_all();
    }
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  class Link final : public WorkerLink {
   public:
    Link(ThreadsRun& run, std::size_t number) : run_(run), number_(number) {}
    std::string ask(std::string_view question) override {
      const std::lock_guard<std::mutex> lock(run_.mutex_);
      return run_.source_.answer_question(number_, std::string(question));
    }
    void note(std::string_view) override {}  // an outcome without failure has no note

   private:
    ThreadsRun& run_;
    std::size_t number_;
  };

  // It waits while another thread's message may still produce more.
  std::optional<WorkerMessage> next(unsigned worker) {
    std::unique_lock<std::mutex> lock(mutex_);
    for (;;) {
      if (failure_) return std::nullopt;
      if (std::optional<WorkerMessage> message = source_.next(worker)) {
        ++at_work_;
        return message;
      }
      if (at_work_ == 0) return std::nullopt;
      changed_.wait(lock);
    }
  }

  const WorkHandler& handler_;
  WorkSource& source_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<unsigned> workers_{0};
  unsigned at_work_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

void run_in_threads(unsigned threads, const WorkHandler& handler, WorkSource& source) {
  ThreadsRun run(handler, source);
  run_on_threads(threads, [&run] { run.work(); });
  run.rethrow();
}

}  // namespace penumbra::platform
