// Tests a pool whose workers do what compilers do at their worst. The workers are this test program, which
// answers with a handler of its own: the product has no way to be told to crash.
#include "platform/worker_pool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "input/input_error.h"
#include "platform/child_process.h"
#include "platform/forbidden_attempts.h"
#include "platform/interrupt.h"
#include "platform/process_end.h"
#include "platform/terminal.h"
#include "platform/test_worker.h"

namespace penumbra::platform {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

void eat_memory() {
  constexpr std::size_t bite = std::size_t{8} << 20;
  for (;;) {
    void* memory = std::malloc(bite);  // NOLINT: it is to be lost
    if (memory != nullptr) std::memset(memory, 1, bite);
  }
}

// There are a few more threads than a worker may have, of small stacks: it is not their memory that ends
// this.
[[noreturn]] void start_threads() {
  pthread_attr_t small;
  ::pthread_attr_init(&small);
  ::pthread_attr_setstacksize(&small, std::size_t{64} << 10U);
  const auto wait = [](void*) -> void* {
    std::this_thread::sleep_for(std::chrono::hours(1));
    return nullptr;
  };
  for (std::size_t i = 0; i < kMostWorkerThreads + 50; ++i) {
    pthread_t thread{};
    if (::pthread_create(&thread, &small, wait, nullptr) != 0) std::abort();
  }
  std::this_thread::sleep_for(std::chrono::hours(1));
  std::abort();
}

[[noreturn]] void compute_for_ever() {
  for (std::atomic<unsigned> i = 0;;) ++i;
}

void compute_for(double seconds) {
  const std::clock_t end = std::clock() + static_cast<std::clock_t>(seconds * CLOCKS_PER_SEC);
  while (std::clock() < end) {
  }
}

std::string misbehave(const std::string& message, WorkerLink& link) {
  if (message == "crash") {
    std::signal(SIGSEGV, SIG_DFL);  // a sanitizer would exit instead
    std::raise(SIGSEGV);
  }
  if (message == "abort") std::abort();
  if (message == "exit") std::_Exit(7);
  if (message == "kill") std::raise(SIGKILL);
  if (message == "compute") compute_for_ever();
  if (message == "work") compute_for(0.4);
  if (message == "sleep") std::this_thread::sleep_for(std::chrono::hours(1));
  if (message == "eat") eat_memory();
  if (message == "start threads") start_threads();
  if (message == "throw") throw std::runtime_error("not today");
  if (message == "environment") throw EnvironmentError("no driver");
  if (message == "note and crash") {
    link.note("first");
    link.note("second");
    std::fprintf(stderr, "the reason\n");
    std::abort();
  }
  if (message == "print") {
    for (int line = 0; line < 20'000; ++line) std::puts("m noise with every kind of frame in it: aaaa hhhh");
    std::fflush(stdout);
  }
  if (message.starts_with("try ")) return attempt(message.substr(4));
  if (message == "answer at length") return std::string(std::size_t{3} << 20U, 'x');
  if (message == "ask") return "answered " + link.ask("what?");
  if (message == "grow") {  // the worker keeps it, as a leak does, but within the limit
    static std::vector<std::string> kept;
    kept.emplace_back(std::size_t{24} << 20U, 'x');
  }
  return message + " done by " + std::to_string(::getpid());
}

class Messages : public WorkSource {
 public:
  explicit Messages(std::vector<std::string> contents) : contents_(std::move(contents)) {}

  std::optional<WorkerMessage> next(unsigned) override {
    if (next_ == contents_.size()) return std::nullopt;
    const std::size_t number = next_++;
    return WorkerMessage{number, contents_[number]};
  }
  std::string answer_question(std::size_t number, const std::string& question) override {
    return question + std::to_string(number);
  }
  void finished(std::size_t number, WorkerOutcome outcome) override {
    EXPECT_TRUE(outcomes.emplace(number, std::move(outcome)).second) << "finished twice";
  }

  std::map<std::size_t, WorkerOutcome> outcomes;

 private:
  std::vector<std::string> contents_;
  std::size_t next_ = 0;
};

WorkerPool small_pool(unsigned workers = 2) {
  WorkerPool pool;
  pool.arguments = {worker_mode};
  pool.workers = workers;
  return pool;
}

std::map<std::size_t, WorkerOutcome> run(const std::vector<std::string>& messages, const WorkerPool& pool) {
  Messages source(messages);
  run_workers(pool, source);
  EXPECT_EQ(source.outcomes.size(), messages.size());
  return source.outcomes;
}

WorkerOutcome run_one(const std::string& message, const WorkerPool& pool = small_pool(1)) {
  return run({message}, pool).at(0);
}

TEST(WorkerPool, AnswersEveryMessage) {
  std::vector<std::string> messages;
  for (int i = 0; i < 200; ++i) messages.push_back("m" + std::to_string(i));
  for (const auto& [number, outcome] : run(messages, small_pool(3))) {
    EXPECT_THAT(outcome.answer, HasSubstr(messages[number] + " done by "));
    EXPECT_THAT(outcome.failure, IsEmpty());
  }
}

TEST(WorkerPool, MessagesOfAnySizeGoBothWays) {
  const std::string large(std::size_t{5} << 20U, 'y');
  EXPECT_THAT(run_one(large).answer, HasSubstr(large + " done by "));
  EXPECT_THAT(run_one("").answer, HasSubstr(" done by "));
}

TEST(WorkerPool, OneWorkerFailsItsMessageAlone) {
  const std::vector<std::string> messages{"a", "crash", "b", "abort", "exit", "kill", "c", "throw", "d"};
  const auto outcomes = run(messages, small_pool(2));
  for (const std::size_t healthy : {0U, 2U, 6U, 8U})
    EXPECT_THAT(outcomes.at(healthy).answer, HasSubstr(messages[healthy] + " done by "));
  EXPECT_EQ(outcomes.at(3).failure, "crashed with SIGABRT");
  EXPECT_EQ(outcomes.at(4).failure, "ended with exit code 7");
  EXPECT_EQ(outcomes.at(5).failure, "was killed externally by SIGKILL");
  EXPECT_TRUE(outcomes.at(5).from_outside);
  EXPECT_FALSE(outcomes.at(3).from_outside);
  EXPECT_EQ(outcomes.at(7).failure, "failed: not today");
}

TEST(WorkerPool, ACrashIsNamedBySignal) {
  EXPECT_EQ(run_one("crash").failure, "crashed with SIGSEGV");
}

TEST(WorkerPool, AComputingWorkerEndsAtItsProcessorTime) {
  WorkerPool pool = small_pool(1);
  pool.limits.processor_time = std::chrono::seconds(1);
  const auto outcomes = run({"compute", "a"}, pool);
  EXPECT_EQ(outcomes.at(0).failure, "took more than 1 s of CPU time");
  EXPECT_THAT(outcomes.at(1).answer, HasSubstr("a done"));
}

TEST(WorkerPool, ProcessorTimeIsCountedAnewForEveryMessage) {
  WorkerPool pool = small_pool(1);
  pool.limits.processor_time = std::chrono::seconds(2);
  // One worker gets all messages, each far below the limit of one message and together beyond it, on a busy
  // machine too.
  for (const auto& [number, outcome] : run(std::vector<std::string>(9, "work"), pool))
    EXPECT_THAT(outcome.answer, HasSubstr("work done"));
}

TEST(WorkerPool, AWaitingWorkerEndsAtItsTime) {
  WorkerPool pool = small_pool(1);
  pool.limits.time = std::chrono::milliseconds(200);
  EXPECT_EQ(run_one("sleep", pool).failure, "took longer than 200 ms");
}

TEST(WorkerPool, AnEaterOfMemoryEndsAtItsLimit) {
  WorkerPool pool = small_pool(2);
  pool.limits.memory = std::size_t{512} << 20U;
  const auto outcomes = run({"a", "eat", "b"}, pool);
  EXPECT_EQ(outcomes.at(1).failure, "took more than 512 MiB of memory");
  EXPECT_THAT(outcomes.at(2).answer, HasSubstr("b done"));
}

TEST(WorkerPool, AStarterOfThreadsEndsAtItsLimit) {
  const auto outcomes = run({"a", "start threads", "b"}, small_pool(2));
  EXPECT_EQ(outcomes.at(1).failure, "started more than 512 threads");
  EXPECT_THAT(outcomes.at(2).answer, HasSubstr("b done"));
}

TEST(WorkerPool, AWorkerThatHasGrownIsReplacedBeforeItCountsAgainstAMessage) {
  WorkerPool pool = small_pool(1);
  pool.limits.memory = std::size_t{400} << 20U;
  const auto outcomes = run(std::vector<std::string>(40, "grow"), pool);  // the answers take 960 MiB in all
  std::map<std::string, int> messages_of;
  for (const auto& [number, outcome] : outcomes) {
    EXPECT_THAT(outcome.failure, IsEmpty());
    ++messages_of[outcome.answer];
  }
  EXPECT_GT(messages_of.size(), 2U);
  EXPECT_LT(messages_of.size(), 20U) << "replaced for no reason";
}

TEST(WorkerPool, MemoryThatIsTakenAtOnceEndsAtTheLimitToo) {
  WorkerPool pool = small_pool(1);
  pool.limits.memory = std::size_t{512} << 20U;
  EXPECT_EQ(run_one("try to allocate 64 GiB", pool).failure, "took more than 512 MiB of memory");
}

TEST(WorkerPool, AnAnswerThatIsTooLongIsAFailure) {
  WorkerPool pool = small_pool(1);
  pool.limits.answer = std::size_t{2} << 20U;
  EXPECT_EQ(run_one("answer at length", pool).failure, "sent a response of more than 2 MiB");
  EXPECT_THAT(ask_worker(pool, "a").answer, HasSubstr("a done"));
}

TEST(WorkerPool, ADeadWorkersNoteAndLastWordsAreKept) {
  const WorkerOutcome outcome = run_one("note and crash");
  EXPECT_EQ(outcome.note, "second");
  EXPECT_EQ(outcome.output_tail, "the reason\n");
}

TEST(WorkerPool, WhatACompilerPrintsDisturbsNothing) {
  for (const auto& [number, outcome] : run(std::vector<std::string>(6, "print"), small_pool(2)))
    EXPECT_THAT(outcome.answer, HasSubstr("print done"));
}

TEST(WorkerPool, AnEnvironmentErrorEndsTheRun) {
  EXPECT_THROW(run({"a", "environment", "b"}, small_pool(2)), EnvironmentError);
}

TEST(WorkerPool, AProgramThatIsNoWorkerIsSaidAtOnce) {
  WorkerPool pool = small_pool(1);
  pool.arguments = {"--gtest_list_tests"};
  Messages source({"a"});
  EXPECT_THROW(run_workers(pool, source), EnvironmentError);
}

// A worker is helped by what it has done before: the number it is asked for by stands for one process.
TEST(WorkerPool, AWorkerIsAskedForByItsOwnNumber) {
  class Numbered final : public Messages {
   public:
    Numbered() : Messages(std::vector<std::string>(40, "link")) {}
    std::optional<WorkerMessage> next(unsigned worker) override {
      std::optional<WorkerMessage> message = Messages::next(worker);
      if (message) workers[message->number] = worker;
      return message;
    }
    std::map<std::size_t, unsigned> workers;
  };
  Numbered source;
  run_workers(small_pool(3), source);
  std::map<unsigned, std::set<std::string>> answers;  // each answer with the process that gave it
  std::set<std::string> all;
  for (const auto& [number, worker] : source.workers) {
    EXPECT_LT(worker, 3U);
    answers[worker].insert(source.outcomes.at(number).answer);
    all.insert(source.outcomes.at(number).answer);
  }
  for (const auto& [worker, of_it] : answers) EXPECT_EQ(of_it.size(), 1U) << worker;
  EXPECT_EQ(all.size(), answers.size());
}

TEST(WorkerPool, MessagesMayComeWhileOthersAreAtWork) {
  class Chain final : public Messages {
   public:
    Chain() : Messages({}) {}
    std::optional<WorkerMessage> next(unsigned) override {
      if (at_work_ || made_ == 20) return std::nullopt;
      at_work_ = true;
      return WorkerMessage{made_++, "link"};
    }
    void finished(std::size_t number, WorkerOutcome outcome) override {
      at_work_ = false;
      Messages::finished(number, std::move(outcome));
    }

   private:
    bool at_work_ = false;
    std::size_t made_ = 0;
  };
  Chain processes;
  run_workers(small_pool(3), processes);
  EXPECT_EQ(processes.outcomes.size(), 20U);
  Chain threads;
  run_in_threads(3, misbehave, threads);
  EXPECT_EQ(threads.outcomes.size(), 20U);
}

TEST(WorkerThreads, AnswerTheSame) {
  Messages source({"a", "ask", "b"});
  run_in_threads(2, misbehave, source);
  EXPECT_EQ(source.outcomes.at(1).answer, "answered what?1");
  EXPECT_EQ(source.outcomes.size(), 3U);
}

TEST(WorkerThreads, ThrowWhatAHandlerThrows) {
  Messages source({"a", "throw", "b", "c"});
  EXPECT_THROW(run_in_threads(2, misbehave, source), std::runtime_error);
}

// A program with one sleeping worker writes the worker's number, and gets `signal` once that is there.
class Stopped : public testing::TestWithParam<const char*> {};

TEST_P(Stopped, ProgramLeavesNoWorker) {
  const auto file = std::filesystem::path(testing::TempDir()) /
                    ("penumbra-worker-of-" + std::to_string(::getpid()) + GetParam());
  std::filesystem::remove(file);
  const ChildResult stopped =
      run_child({"sh",
                 {"-c", "'" + program_path().string() + "' --run-a-sleeper '" + file.string() +
                            "' & p=$!; until [ -s '" + file.string() + "' ]; do sleep 0.02; done; kill -" +
                            GetParam() + " $p; wait $p"},
                 {}});
  EXPECT_FALSE(stopped.timed_out);
  int worker = 0;
  std::ifstream(file) >> worker;
  ASSERT_GT(worker, 0);
  wait_for_the_end_of(worker);
  std::filesystem::remove(file);
}

INSTANTIATE_TEST_SUITE_P(By, Stopped, testing::Values("INT", "TERM", "KILL"));

std::string sleep_for_long(const std::string&, WorkerLink&) {
  std::this_thread::sleep_for(std::chrono::hours(1));
  return {};
}

// The worker is told before it is confined, because after that it writes no file.
int sleep_and_tell(const std::string& file) {
  return serve_worker(sleep_for_long, [&](const WorkerLimits&) {
    std::ofstream(file) << ::getpid() << "\n" << std::flush;
  });
}

int run_a_sleeper(const std::string& file) {
  watch_interrupts();
  WorkerPool pool;
  pool.arguments = {"--sleep-and-tell", file};
  Messages source({"sleep"});
  try {
    run_workers(pool, source);
  } catch (const Interrupted&) {
    return 130;
  }
  return 0;
}

}  // namespace
}  // namespace penumbra::platform

int main(int argc, char** argv) {
  const std::string mode = argc > 1 ? argv[1] : "";
  if (mode == penumbra::platform::worker_mode)
    return penumbra::platform::serve_worker(penumbra::platform::misbehave);
  if (mode == "--sleep-and-tell") return penumbra::platform::sleep_and_tell(argv[2]);
  if (mode == "--run-a-sleeper") return penumbra::platform::run_a_sleeper(argv[2]);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
