// penumbra: the program. Its command line is command_line.h; each subcommand is a file of its own beside this
// one. Started with a worker's mode it is that worker instead, and reads no command line.
#include <cstdio>
#include <exception>
#include <optional>
#include <string_view>

#include "cli/command_line.h"
#include "cost/module_compiler.h"
#include "platform/interrupt.h"
#include "resolve/module_order.h"
#include "scene/reading_process.h"
#include "validation/engine.h"

namespace {

// Returns the exit code of a worker; nothing if the program was started by a user.
std::optional<int> serve_as_worker(int argc, char** argv) {
  const std::string_view mode = argc > 1 ? argv[1] : "";
  if (mode == penumbra::validation::worker_mode)
    return penumbra::validation::serve_units({argv + 2, argv + argc});
  if (mode == penumbra::cost::compiler_worker_mode)
    return penumbra::cost::serve_compiler({argv + 2, argv + argc});
  if (argc != 2) return std::nullopt;
  if (mode == penumbra::resolve::modules_mode) return penumbra::resolve::serve_modules();
  if (mode == penumbra::scene::reading_mode) return penumbra::scene::serve_readings();
  return std::nullopt;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (const std::optional<int> code = serve_as_worker(argc, argv)) return *code;
    penumbra::cli::answer_uncaught_exceptions();
    penumbra::platform::watch_interrupts();
    return penumbra::cli::run_command_line({argv + 1, argv + argc});
  } catch (...) {
    std::fprintf(stderr, "penumbra: %s\n",
                 penumbra::cli::failure_of(std::current_exception()).message.c_str());
    return penumbra::cli::internal_error;
  }
}
