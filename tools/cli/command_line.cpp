#include "cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <regex>
#include <sstream>
#include <utility>

#include "cli/help.h"
#include "cli/option_values.h"
#include "input/input_error.h"
#include "input/nearest_name.h"
#include "platform/interrupt.h"

namespace penumbra::cli {
namespace {

constexpr const char* out_of_memory =
    "out of memory; use a smaller picture, map, scene or file, or fewer --jobs";

Failure mistake_of_ours(const std::string& what) {
  return {internal_error, "internal error: " + what +
                              "\n  this is a bug in penumbra " PENUMBRA_VERSION
                              ", not in your input; please report it with the command line"};
}

Failure described(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const platform::Interrupted&) {
    const int signal = platform::interrupting_signal();
    return {signal == 0 ? interrupted : static_cast<ExitCode>(128 + signal), platform::interrupted_message};
  } catch (const InputError& error) {
    return {bad_input, error.what()};
  } catch (const EnvironmentError& error) {
    return {bad_environment, error.what()};
  } catch (const std::filesystem::filesystem_error& error) {
    return {bad_input, error.what()};
  } catch (const std::bad_alloc&) {
    return {bad_environment, out_of_memory};
  } catch (const std::exception& error) {
    return mistake_of_ours(error.what());
  } catch (...) {
    return mistake_of_ours("of unknown kind");
  }
}

// The function allocates nothing.
[[noreturn]] void end_uncaught() {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "penumbra: %s\n", out_of_memory);
    std::_Exit(bad_environment);
  } catch (...) {
  }
  std::abort();
}

// These are names that other programs, or other subcommands of this one, use for an option. Of several, the
// first that the subcommand has is suggested.
constexpr std::pair<const char*, const char*> kOtherNames[] = {
    {"report", "format"},
    {"form", "format"},
    {"out", "output"},
    {"folder", "output"},
    {"angle", "light"},
    {"diameter", "light"},
    {"resolution", "map-size"},
    {"resolution", "size"},
    {"shadow-distance", "distance"},
    {"threads", "jobs"},
    {"parallel", "jobs"},
    {"conventional-z", "reversed-z"},
    {"techniques", "technique"},
    {"techniques", "technique-list"},
    {"keywords", "keyword-set"},
    {"list", "count"},
    {"list", "list-techniques"},
    {"dry-run", "count"},
    {"samples", "reference-samples"},
    {"silent", "quiet"},
};

bool is_option(const std::string& argument) {
  return argument.size() > 1 && argument.front() == '-' && argument != "--";
}

std::vector<std::string> long_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* app = &command; app != nullptr; app = app->get_parent())
    for (const CLI::Option* option : app->get_options())
      names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
  return names;
}

std::string nearest_option(const CLI::App& command, const std::string& given) {
  const std::vector<std::string> known = long_names(command);
  const auto has = [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  };
  for (const auto& [other, ours] : kOtherNames)
    if (given == other && has(ours)) return ours;
  return nearest_name(given, known);
}

std::string called(const CLI::App& command) {
  return command.get_parent() == nullptr ? command.get_name() : "penumbra " + command.get_name();
}

std::string lines(const std::string& first, const std::string& second) {
  return first.empty() ? second : first + "\n  " + second;
}

std::string see_help(const CLI::App& command) {
  return "see: " + called(command) + " --help";
}

InputError unknown_option(const CLI::App& command, const std::string& argument) {
  const std::string typed = argument.substr(0, argument.find('='));
  std::string nearest;
  if (typed.starts_with("--")) nearest = nearest_option(command, typed.substr(2));
  return {"", called(command) + " has no option '" + typed + "'",
          lines(nearest.empty() ? "" : "did you mean '--" + nearest + "'?", see_help(command))};
}

InputError too_many(const CLI::App& command, const std::string& argument) {
  return {"", called(command) + " does not expect '" + argument + "'", see_help(command)};
}

// CLI11's messages, rewritten in this program's terms.
std::string plain_words(const std::string& said) {
  static const std::pair<std::regex, const char*> kWords[] = {
      {std::regex("^(\\S+): is empty$"), "$1 is empty"},
      {std::regex("^(\\S+): At Most 1 required but received 2$"), "$1 is given twice"},
      {std::regex("^(\\S+): At Most 1 required but received (\\d+)$"), "$1 is given $2 times"},
      {std::regex("^(\\S+): At Most (\\d+) required but received (\\d+)$"),
       "$1 takes at most $2 numbers, not $3"},
      {std::regex("^(\\S+): At least (\\d+) required but received (\\d+)$"),
       "$1 takes at least $2 numbers, not $3"},
      {std::regex("^(\\S+): \\d+ required (.+) missing$"), "$1 is given without its $2"},
      {std::regex("^Could not convert: (\\S+) = (.*)$"), "$1 does not take the value '$2'"},
      {std::regex("^(\\S+) requires (\\S+)$"), "$1 needs $2"},
  };
  for (const auto& [theirs, ours] : kWords)
    if (std::regex_match(said, theirs)) return std::regex_replace(said, theirs, ours);
  return said;
}

InputError unknown_subcommand(CLI::App& app, const std::string& name) {
  std::vector<std::string> known;
  for (const CLI::App* command : shown_subcommands(app)) known.push_back(command->get_name());
  return {"", "unknown subcommand '" + name + "'", lines(unknown_name_remedy(name, known), see_help(app))};
}

// `app` is the tree whose parse() threw.
InputError usage_error(CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  const std::vector<std::string> unexpected = app.remaining(true);
  const auto option = std::find_if(unexpected.begin(), unexpected.end(), is_option);
  if (chosen.empty() && !unexpected.empty() && option != unexpected.begin())
    return unknown_subcommand(app, unexpected.front());
  if (option != unexpected.end()) return unknown_option(command, *option);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !unexpected.empty())
    return too_many(command, unexpected.front());
  const std::string said = plain_words(error.what());  // the message's own way out follows on further lines
  const std::size_t end = std::min(said.find("\n  "), said.size());
  return {"", said.substr(0, end), lines(end < said.size() ? said.substr(end + 3) : "", see_help(command))};
}

constexpr const char* kExitCodes =
    "Exit codes:\n"
    "  0    success\n"
    "  1    findings: a variant fails, a figure is worse than its baseline, results are invalid, a "
    "file is outdated\n"
    "  2    usage or input error: correct the command line or the file\n"
    "  3    environment error: no Vulkan device, a missing package, too little memory\n"
    "  70   a bug in penumbra, or a compiler that crashed; please report it\n"
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

void answer_uncaught_exceptions() {
  std::set_terminate(end_uncaught);
}

Failure failure_of(const std::exception_ptr& thrown) {
  try {
    return described(thrown);
  } catch (const std::bad_alloc&) {
    return {bad_environment, "out of memory"};  // short enough to need no memory
  }
}

}  // namespace penumbra::cli
