#include "platform/worker_environment.h"

#ifndef _WIN32

#include <algorithm>
#include <string_view>

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

}  // namespace

std::vector<std::string> worker_environment() {
  std::vector<std::string> variables;
  for (char** at = environ; *at != nullptr; ++at) {
    const std::string_view variable = *at;
    if (is_needed(variable.substr(0, variable.find('=')))) variables.emplace_back(variable);
  }
  return variables;
}

}  // namespace penumbra::platform

#endif
