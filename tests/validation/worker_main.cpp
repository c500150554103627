// The test program is its own worker, as the product is. One kind of worker behaves as the product's; another
// does on demand what compilers do at their worst, which the product cannot be told to do.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <thread>

#include "validation/answer_unit.h"
#include "validation/cache_processes.h"
#include "validation/target_check.h"
#include "validation/unit_message.h"
#include "validation/validation_units.h"

namespace penumbra::validation {
namespace {

// Takes a byte from a pipe in the file system, which holds one: a worker can write nothing down.
bool takes_a_byte(const std::string& pipe) {
  const int descriptor = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  char byte = 0;
  const bool taken = ::read(descriptor, &byte, 1) == 1;
  ::close(descriptor);
  return taken;
}

void misbehave(const std::string& how) {
  if (how == "crash") std::abort();
  if (how == "throw") throw std::logic_error("a mistake");
  if (how == "kill") std::raise(SIGKILL);
  if (how.starts_with("kill-once:") && takes_a_byte(how.substr(10))) std::raise(SIGKILL);
  if (how.starts_with("crash-counted:") && takes_a_byte(how.substr(14))) std::abort();
  if (how == "hang") std::this_thread::sleep_for(std::chrono::hours(1));
  while (how == "eat") {
    constexpr std::size_t bite = std::size_t{8} << 20U;
    if (void* memory = std::malloc(bite)) std::memset(memory, 1, bite);  // NOLINT: it is to be lost
  }
}

// Goes wrong at one place of the work: where the text is made, before it is compiled, or in a target.
class MisbehavingLink final : public platform::WorkerLink {
 public:
  MisbehavingLink(platform::WorkerLink& link, const std::string& order)
      : link_(link), how_(order.substr(0, order.find('@'))), where_(order.substr(order.find('@') + 1)) {}

  std::string ask(std::string_view question) override {
    std::string answer = link_.ask(question);
    const bool compiles = question.front() == question_text && answer == answer_mine;
    if (compiles && where_ == "spirv") misbehave(how_);
    return answer;
  }
  void note(std::string_view text) override {
    link_.note(text);
    if (text != note_compile && where_ == (text == note_text ? "preprocess" : text)) misbehave(how_);
  }

 private:
  platform::WorkerLink& link_;
  std::string how_;
  std::string where_;
};

std::string answer_or_misbehave(const std::string& job, platform::WorkerLink& link) {
  const std::optional<UnitJob> decoded = decode_job(job);
  static UnitService service;
  for (const auto& [name, value] : decoded->unit.compile.defines) {
    if (name != "MISBEHAVE") continue;
    MisbehavingLink bad(link, value);
    return service.answer(job, bad);
  }
  return service.answer(job, link);
}

}  // namespace
}  // namespace penumbra::validation

int main(int argc, char** argv) {
  namespace validation = penumbra::validation;
  const std::string mode = argc > 1 ? argv[1] : "";
  if (mode == validation::worker_mode) return validation::serve_units({argv + 2, argv + argc});
  if (mode == validation::misbehaving_mode)
    return penumbra::platform::serve_worker(validation::answer_or_misbehave,
                                            [argc, argv](const penumbra::platform::WorkerLimits&) {
                                              validation::open_drivers({argv + 2, argv + argc});
                                            });
  if (mode == validation::cache_user_mode) return validation::use_cache(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
