#include "cli/command_line.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <sstream>

#include "cli/failure.h"
#include "cli/help.h"
#include "cli/option_values.h"
#include "cli/usage_error.h"

namespace penumbra::cli {
namespace {

constexpr const char* kExitCodes =
    "Exit codes:\n"
    "  0    success\n"
    "  1    findings: a variant fails, a figure is worse than its baseline, results are invalid, a "
    "file is outdated\n"
    "  2    usage or input error: correct the command line or the file\n"
    "  3    environment error: no Vulkan device, a missing package, too little memory\n"
    "  70   a bug in penumbra; please report it\n"
    "  130  interrupted, by Ctrl-C for example; finished work is kept\n"
    "  143  ended by SIGTERM, by a time limit for example; finished work is kept\n"
    "Progress goes to standard error: a bar on a terminal, otherwise a line every 10 s; --quiet turns it "
    "off.";

// `penumbra help measure` prints what `penumbra measure --help` prints. It takes a separate option tree: in
// the parsed one, CLI11's help() returns that of the parsed subcommand.
std::string help_on(const std::string& name) {
  Context unused;
  const std::unique_ptr<CLI::App> app = command_line(unused);
  if (name.empty()) return app->help();
  for (const CLI::App* known : shown_subcommands(*app))
    if (known->get_name() == name) return known->help("penumbra");
  throw unknown_subcommand(*app, name);
}

void add_help(CLI::App& app) {
  CLI::App* command = app.add_subcommand("help", "Help on the program or on a subcommand");
  auto name = std::make_shared<std::string>();
  command->add_option("subcommand", *name, "Subcommand to explain")
      ->type_name("SUBCOMMAND")
      ->default_str("the whole program");
  end_help(*command, "", {{"penumbra help measure", ""}});
  command->callback([name] { write_output("", help_on(*name)); });
}

// An empty text means no keywords, and an empty variant is refused with a list of those that exist, so both
// may be empty.
void refuse_empty_values(CLI::App& app) {
  for (CLI::App* command : shown_subcommands(app)) {
    for (CLI::Option* option : command->get_options()) {
      const std::string placeholder = value_hint(*option).placeholder;
      const bool may_be_empty =
          placeholder == "EXPRESSION" || placeholder == "VARIANT" || placeholder.starts_with("KEYWORD");
      if (!placeholder.empty() && !may_be_empty) not_empty(option);
    }
  }
}

int run(const std::vector<std::string>& arguments) {
  Context context;
  context.arguments = arguments;
  const std::unique_ptr<CLI::App> app = command_line(context);
  try {
    std::vector<std::string> last_first(arguments.rbegin(), arguments.rend());
    app->parse(last_first);
  } catch (const CLI::Success& asked) {
    std::ostringstream text;  // the requested help or version
    const int code = app->exit(asked, text, text);
    write_output("", text.str());
    return code;
  } catch (const CLI::ParseError& error) {
    throw usage_error(*app, error);
  }
  if (app->get_subcommands().empty()) write_output("", app->help());
  return context.exit_code;
}

}  // namespace

std::unique_ptr<CLI::App> command_line(Context& context) {
  auto app = std::make_unique<CLI::App>("Soft shadows for Unity, measured against ray tracing.", "penumbra");
  app->set_version_flag("--version", "penumbra " PENUMBRA_VERSION);
  app->require_subcommand(0, 1);
  app->footer(kExitCodes);
  app->add_flag("-q,--quiet", context.quiet, "Print no progress and no notes on standard error");
  app->fallthrough();
  app->option_defaults()->always_capture_default();
  lay_out_help(*app);
  add_constants(*app, context);
  add_tables(*app, context);
  add_validate(*app, context);
  add_emit(*app, context);
  add_cost(*app, context);
  add_merge(*app, context);
  add_render(*app, context);
  add_measure(*app, context);
  add_bake(*app, context);
  add_completion(*app);
  add_help(*app);
  refuse_empty_values(*app);
  return app;
}

std::vector<CLI::App*> shown_subcommands(CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

int run_command_line(const std::vector<std::string>& arguments) {
  try {
    return run(arguments);
  } catch (...) {
    const Failure failure = failure_of(std::current_exception());
    std::fprintf(stderr, "penumbra: %s\n", failure.message.c_str());
    return failure.code;
  }
}

}  // namespace penumbra::cli
