// penumbra completion: scripts that let bash, zsh and fish complete subcommands, options and their values.
// They are made from the tree of the command line, so what is added there is completed, too.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

#include "cli/command_line.h"
#include "cli/help.h"
#include "cli/known_names.h"
#include "cli/option_values.h"
#include "cli/shell_script.h"
#include "cli/subcommand.h"

namespace penumbra::cli {
namespace {

std::vector<std::string> known_names(const std::string& placeholder) {
  std::vector<std::string> names;
  for (const NameKind& kind : name_kinds()) {
    if (kind.placeholder != placeholder) continue;
    for (const KnownName& known : kind.names()) names.push_back(known.name);
  }
  return names;
}

CompletedOption completed(const CLI::Option& option) {
  const ValueHint hint = value_hint(option);
  CompletedOption result;
  for (const std::string& name : option.get_snames()) result.short_names.push_back(name);
  for (const std::string& name : option.get_lnames()) result.long_names.push_back(name);
  result.description = option.get_description();
  result.placeholder = hint.placeholder;
  result.words = hint.choices.empty() ? known_names(hint.placeholder) : hint.choices;
  result.list = option.get_delimiter() == ',' || hint.placeholder == "SCENE";
  result.files = hint.placeholder == "FILE" || hint.placeholder == "SCENE";
  result.folders = hint.placeholder == "FOLDER";
  return result;
}

CompletedCommand completed(const CLI::App& command, const std::vector<std::string>& subcommands) {
  CompletedCommand result{command.get_name(), command.get_description(), {}, {}, false};
  for (const CLI::Option* option : command.get_options()) {
    if (option->nonpositional()) {
      result.options.push_back(completed(*option));
      continue;
    }
    const CompletedOption positional = completed(*option);
    result.words = positional.placeholder == "SUBCOMMAND" ? subcommands : positional.words;
    result.files = positional.files;
  }
  return result;
}

std::string script_for(const std::string& shell) {
  Context unused;
  const std::unique_ptr<CLI::App> app = command_line(unused);
  std::vector<std::string> names;
  for (const CLI::App* command : shown_subcommands(*app)) names.push_back(command->get_name());
  std::vector<CompletedCommand> commands{completed(*app, names)};
  for (const CLI::App* command : shown_subcommands(*app)) commands.push_back(completed(*command, names));
  if (shell == "zsh") return zsh_script(commands);
  return shell == "fish" ? fish_script(commands) : bash_script(commands);
}

// The shells are few enough to name all, even where one is near.
CLI::Validator known_shell() {
  const CLI::Validator known = one_of({"bash", "zsh", "fish"});
  const auto check = [known](std::string& text) {
    const std::string said = known(text);
    return said.empty() ? said
                        : fmt::format("there is no completion for '{}'\n  known are: bash, zsh, fish", text);
  };
  return {check, known.get_description()};
}

}  // namespace

void add_completion(CLI::App& app) {
  CLI::App* command = app.add_subcommand("completion", "Print the completion script for a shell");
  auto shell = std::make_shared<std::string>();
  command->add_option("shell", *shell, "The shell")->type_name("SHELL")->check(known_shell())->required();
  end_help(*command, "",
           {{"source <(penumbra completion bash)", "in ~/.bashrc"},
            {"source <(penumbra completion zsh)", "in ~/.zshrc, after compinit"},
            {"penumbra completion fish | source", "in ~/.config/fish/config.fish"}});
  command->callback([shell] { write_output("", script_for(*shell)); });
}

}  // namespace penumbra::cli
