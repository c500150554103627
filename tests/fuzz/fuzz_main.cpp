// libFuzzer's entry points. One program holds all targets, because linking the instrumented libraries takes
// longer than compiling a target; the name it is called by says which one runs: fuzz_TARGET.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string>
#include <string_view>

#include "fuzz/targets.h"

namespace penumbra::fuzz {
namespace {

struct Target {
  std::string_view name;
  void (*run)(std::string_view bytes);
};

constexpr Target all_targets[] = {{"cache_entries", targets::cache_entries},
                                  {"expanded_text", targets::expanded_text},
                                  {"figures", targets::figures},
                                  {"messages", targets::messages},
                                  {"model", targets::model},
                                  {"option_values", targets::option_values},
                                  {"picture", targets::picture},
                                  {"pragmas", targets::pragmas},
                                  {"preparation", targets::preparation},
                                  {"preprocessing", targets::preprocessing},
                                  {"project_files", targets::project_files},
                                  {"report", targets::report},
                                  {"settings", targets::settings},
                                  {"shaderlab", targets::shaderlab},
                                  {"source_text", targets::source_text},
                                  {"stripping", targets::stripping},
                                  {"technique_list", targets::technique_list},
                                  {"worker_messages", targets::worker_messages}};

const Target* chosen = nullptr;

const Target* target_of(std::string_view program) {
  for (const Target& target : all_targets)
    if (program.ends_with("/fuzz_" + std::string(target.name))) return &target;
  return nullptr;
}

}  // namespace
}  // namespace penumbra::fuzz

extern "C" int LLVMFuzzerInitialize(const int* /*count*/, char*** arguments) {
  using namespace penumbra::fuzz;
  chosen = target_of("/" + std::string((*arguments)[0]));
  if (chosen != nullptr) return 0;
  std::fputs("call this program as fuzz_TARGET; the targets are", stderr);
  for (const Target& target : all_targets) std::fprintf(stderr, " %s", target.name.data());
  std::fputs("\n", stderr);
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  penumbra::fuzz::chosen->run({reinterpret_cast<const char*>(data), size});
  return 0;
}

// Memory that the model importer forgets is not ours.
extern "C" int __lsan_is_turned_off() {
  return penumbra::fuzz::chosen != nullptr && penumbra::fuzz::chosen->name == "model" ? 1 : 0;
}
