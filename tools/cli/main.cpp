// penumbra: the program. Its command line is command_line.h; each subcommand is a file of its own beside this
// one.
#include <cstdio>
#include <exception>
#include <string_view>

#include "cli/command_line.h"
#include "cli/failure.h"
#include "cost/compiler_worker.h"
#include "platform/interrupt.h"
#include "validation/engine.h"

int main(int argc, char** argv) {
  try {
    if (argc > 1 && std::string_view(argv[1]) == penumbra::validation::worker_mode)
      return penumbra::validation::serve_units({argv + 2, argv + argc});
    if (argc == 2 && std::string_view(argv[1]) == penumbra::cost::compiler_worker_mode)
      return penumbra::cost::serve_compiler();
    penumbra::platform::watch_interrupts();
    return penumbra::cli::run_command_line({argv + 1, argv + argc});
  } catch (...) {
    std::fprintf(stderr, "penumbra: %s\n",
                 penumbra::cli::failure_of(std::current_exception()).message.c_str());
    return penumbra::cli::internal_error;
  }
}
