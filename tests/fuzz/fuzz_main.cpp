// libFuzzer's entry points. One program holds all targets, because linking the instrumented libraries takes
// longer than compiling a target; the name it is called by says which one runs: fuzz_TARGET.
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iterator>
#include <string>
#include <string_view>

#include "fuzz/fuzz_input.h"
#include "fuzz/json_mutator.h"
#include "fuzz/targets.h"

namespace penumbra::fuzz {
namespace {

enum class Inputs { bytes, json };

struct Target {
  std::string_view name;
  void (*run)(std::string_view bytes);
  Inputs inputs = Inputs::bytes;
};

constexpr Target all_targets[] = {{"bake", targets::bake, Inputs::json},
                                  {"bytecode", targets::bytecode},
                                  {"cache_entries", targets::cache_entries},
                                  {"expanded_text", targets::expanded_text},
                                  {"figures", targets::figures, Inputs::json},
                                  {"messages", targets::messages},
                                  {"model", targets::model},
                                  {"option_values", targets::option_values},
                                  {"picture", targets::picture},
                                  {"pragmas", targets::pragmas},
                                  {"preparation", targets::preparation},
                                  {"preprocessing", targets::preprocessing},
                                  {"project_files", targets::project_files},
                                  {"report", targets::report, Inputs::json},
                                  {"settings", targets::settings, Inputs::json},
                                  {"shaderlab", targets::shaderlab},
                                  {"source_text", targets::source_text},
                                  {"stripping", targets::stripping},
                                  {"technique_list", targets::technique_list, Inputs::json},
                                  {"worker_messages", targets::worker_messages}};

const Target* chosen = nullptr;

const Target* target_of(std::string_view program) {
  for (const Target& target : all_targets)
    if (program.ends_with("/fuzz_" + std::string(target.name))) return &target;
  return nullptr;
}

// libFuzzer's own limit is of wall time, in which a loaded machine does little; at SIGUSR1 it ends as at that
// limit.
void end_after_processor_seconds(const char* text) {
  if (text == nullptr) return;
  sigevent at_end{};
  at_end.sigev_notify = SIGEV_SIGNAL;
  at_end.sigev_signo = SIGUSR1;
  itimerspec limit{};
  limit.it_value.tv_sec = std::strtol(text, nullptr, 10);
  timer_t timer{};
  if (limit.it_value.tv_sec > 0 && timer_create(CLOCK_PROCESS_CPUTIME_ID, &at_end, &timer) == 0 &&
      timer_settime(timer, 0, &limit, nullptr) == 0)
    return;
  std::fputs("PENUMBRA_FUZZ_SECONDS is the seconds of processor time to run for, 1 or more\n", stderr);
  std::exit(2);
}

}  // namespace
}  // namespace penumbra::fuzz

extern "C" int LLVMFuzzerInitialize(const int* /*count*/, char*** arguments) {
  using namespace penumbra::fuzz;
  chosen = target_of("/" + std::string((*arguments)[0]));
  end_after_processor_seconds(std::getenv("PENUMBRA_FUZZ_SECONDS"));
  if (chosen != nullptr) return 0;
  std::fputs("call this program as fuzz_TARGET; the targets are", stderr);
  for (const Target& target : all_targets) std::fprintf(stderr, " %s", target.name.data());
  std::fputs("\n", stderr);
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // libFuzzer's own limit for one input is of wall time too, and there only for hangs.
  constexpr std::clock_t longest = 25 * CLOCKS_PER_SEC;
  const std::clock_t start = std::clock();
  penumbra::fuzz::chosen->run({reinterpret_cast<const char*>(data), size});
  penumbra::fuzz::require(std::clock() - start <= longest,
                          "an input takes at most 25 seconds of processor time");
  return 0;
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  using namespace penumbra::fuzz;
  return chosen->inputs == Inputs::json ? mutate_json(data, size, most, seed)
                                        : LLVMFuzzerMutate(data, size, most);
}

// Memory that the model importer forgets is not ours.
extern "C" int __lsan_is_turned_off() {
  return penumbra::fuzz::chosen != nullptr && penumbra::fuzz::chosen->name == "model" ? 1 : 0;
}
