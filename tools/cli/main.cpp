// penumbra: the command line. Each subcommand is a file of its own beside this one.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <string_view>

#include "cli/subcommand.h"
#include "input/input_error.h"
#include "platform/interrupt.h"
#include "validation/engine.h"

namespace {

using penumbra::cli::ExitCode;

int report(const char* kind, const char* message, ExitCode code) {
  std::fprintf(stderr, "penumbra: %s%s\n", kind, message);
  return code;
}

int run(int argc, char** argv) {
  penumbra::platform::watch_interrupts();
  CLI::App app{"Soft shadows for Unity whose error is known."};
  app.set_version_flag("--version", "penumbra " PENUMBRA_VERSION);
  app.require_subcommand(1);
  app.footer("Exit codes: 0 success, 1 findings, 2 bad usage or input, 3 missing device or package.");

  penumbra::cli::Context context;
  context.arguments.assign(argv + 1, argv + argc);
  app.add_flag("-q,--quiet", context.quiet, "No progress and no notes on stderr");
  app.fallthrough();
  penumbra::cli::add_constants(app, context);
  penumbra::cli::add_tables(app, context);
  penumbra::cli::add_validate(app, context);
  penumbra::cli::add_cost(app, context);
  penumbra::cli::add_merge(app, context);
  penumbra::cli::add_render(app, context);
  penumbra::cli::add_measure(app, context);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return code == 0 ? ExitCode::success : ExitCode::bad_input;
  }
  return context.exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 2 && std::string_view(argv[1]) == penumbra::validation::worker_mode)
      return penumbra::validation::serve_units();
    return run(argc, argv);
  } catch (const penumbra::platform::Interrupted&) {
    return report("", "interrupted; finished work is kept and the same command goes on from there",
                  ExitCode::interrupted);
  } catch (const penumbra::InputError& error) {
    return report("", error.what(), ExitCode::bad_input);
  } catch (const penumbra::EnvironmentError& error) {
    return report("", error.what(), ExitCode::bad_environment);
  } catch (const std::bad_alloc&) {
    return report("", "out of memory; ask for a smaller image, map or scene", ExitCode::bad_environment);
  } catch (const std::exception& error) {
    return report("internal error: ", error.what(), ExitCode::bad_environment);
  }
}
