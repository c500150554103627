// penumbra completion: scripts that let bash, zsh and fish complete subcommands, options and their values.
// They are made from the tree of the command line, so what is added there is completed, too.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "cli/help.h"
#include "cli/known_names.h"
#include "cli/option_values.h"
#include "cli/subcommand.h"

namespace penumbra::cli {
namespace {

// The completion scripts of three shells, from a plain description of the command line.
struct CompletedOption {
  std::vector<std::string> short_names;  // names without dashes
  std::vector<std::string> long_names;
  std::string description;
  std::string placeholder;         // empty for a flag, which takes no value
  std::vector<std::string> words;  // values that are known
  bool list = false;               // several words, separated by commas
  bool files = false;              // the value may be a file
  bool folders = false;            // the value is a folder
};

struct CompletedCommand {
  std::string name;
  std::string description;
  std::vector<CompletedOption> options;
  std::vector<std::string> words;  // words of its positional arguments
  bool files = false;              // positional arguments are files
};

std::string words_text(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::string quoted(const std::string& text) {
  return "'" + replaced(text, "'", "'\\''") + "'";
}

// Returns "-o" and "--output" of an option.
std::vector<std::string> dashed(const CompletedOption& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.short_names) names.push_back("-" + name);
  for (const std::string& name : option.long_names) names.push_back("--" + name);
  return names;
}

std::vector<std::string> subcommands(const std::vector<CompletedCommand>& commands) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i < commands.size(); ++i) names.push_back(commands[i].name);
  return names;
}

const char* made_by = "# Made by `penumbra completion {}`: make it again when penumbra is another version.\n";

// Returns the code with which bash completes the value of an option.
std::string bash_value(const CompletedOption& option) {
  const char* from = option.folders ? "folder" : option.files ? "file" : "none";
  return fmt::format("from={} list={} words='{}'", from, option.list ? "yes" : "", words_text(option.words));
}

std::string bash_values(const CompletedCommand& command, bool of_program) {
  std::string text;
  for (const CompletedOption& option : command.options) {
    if (option.placeholder.empty()) continue;
    for (const std::string& name : dashed(option))
      text += fmt::format("    {}) {} ;;\n",
                          of_program ? "*' " + name + "'" : "'" + command.name + " " + name + "'",
                          bash_value(option));
  }
  return text;
}

std::string bash_options(const CompletedCommand& command) {
  std::vector<std::string> names;
  for (const CompletedOption& option : command.options)
    for (const std::string& name : dashed(option)) names.push_back(name);
  return words_text(names);
}

// Brackets and colons are special in a spec of zsh's _arguments.
std::string zsh_text(const std::string& text) {
  return replaced(replaced(replaced(text, "[", "("), "]", ")"), ":", " -");
}

std::string zsh_value(const CompletedOption& option) {
  std::vector<std::string> words{" _penumbra_words", option.list ? "list" : "one",
                                 option.files ? "files" : "none"};
  for (const std::string& word : option.words) words.push_back(replaced(word, ":", "\\:"));
  const std::string action = option.folders                          ? "_files -/"
                             : option.words.empty() && option.files  ? "_files"
                             : option.words.empty() && !option.files ? " "
                                                                     : words_text(words);
  return ":" + zsh_text(option.placeholder) + ":" + action;
}

std::string zsh_specs(const CompletedCommand& command) {
  std::string text;
  for (const CompletedOption& option : command.options)
    for (const std::string& name : dashed(option)) {
      const std::string value = option.placeholder.empty() ? "" : zsh_value(option);
      const bool joined = !value.empty() && name.starts_with("--");  // "--option=value" is one, too
      text += "    " +
              quoted("*" + name + (joined ? "=[" : "[") + zsh_text(option.description) + "]" + value) + "\n";
    }
  return text;
}

std::string fish_value(const CompletedOption& option) {
  if (option.placeholder.empty()) return "";
  if (option.folders) return " -x -a '(__fish_complete_directories)'";
  const std::string more = option.files ? " -r -F" : " -x";
  if (option.words.empty()) return more;
  return more + " -a " +
         quoted(option.list ? "(__fish_append , " + words_text(option.words) + ")"
                            : words_text(option.words));
}

std::string fish_options(const CompletedCommand& command, const std::string& condition) {
  std::string text;
  for (const CompletedOption& option : command.options) {
    text += "complete -c penumbra" + condition;
    for (const std::string& name : option.short_names) text += " -s " + name;
    for (const std::string& name : option.long_names) text += " -l " + name;
    text += fish_value(option) + " -d " + quoted(option.description) + "\n";
  }
  return text;
}

// The first command is the program itself, whose options go with every subcommand.
std::string bash_script(const std::vector<CompletedCommand>& commands) {
  const CompletedCommand& program = commands.front();
  std::string names;
  for (const std::string& name : subcommands(commands)) names += (names.empty() ? "" : "|") + name;
  std::string script = fmt::format(fmt::runtime(made_by), "bash");
  // Bash splits words at the : of package:NAME and the = of --option=VALUE, and replaces the part after the
  // last one.
  script += fmt::format(R"(_penumbra() {{
  local line=${{COMP_LINE:0:COMP_POINT}} given=() command='' i rest word
  for ((i = 0; i <= COMP_CWORD; ++i)); do
    rest=${{line#"${{line%%[![:blank:]]*}}"}}
    [ "$i" -lt "$COMP_CWORD" ] && word=${{COMP_WORDS[i]}} || word=$rest
    if [ "$i" -gt 0 ] && [ "$rest" = "$line" ]; then given[-1]+=$word; else given+=("$word"); fi
    line=${{rest#"$word"}}
  done
  local current=${{given[-1]}} previous=${{given[-2]}} option=''
  for word in "${{given[@]:1:${{#given[@]}}-2}}"; do
    case $word in {}) command=$word && break ;; esac
  done
  if [[ $current == --*=* ]]; then
    previous=${{current%%=*}} option=${{current%%=*}}=
    current=${{current#*=}}
  fi
  local from='' list='' words='' before=''
  case "$command $previous" in
)",
                        names);
  for (std::size_t i = 1; i < commands.size(); ++i) script += bash_values(commands[i], false);
  script += bash_values(program, true);
  script += "  esac\n  if [ -z \"$from\" ] && [[ $current == -* ]]; then\n    case $command in\n";
  for (std::size_t i = 1; i < commands.size(); ++i)
    script += fmt::format("      {}) words='{}' ;;\n", commands[i].name, bash_options(commands[i]));
  script += fmt::format("    esac\n    words+=' {}'\n", bash_options(program));
  script += "  elif [ -z \"$from\" ]; then\n    case $command in\n";
  script += fmt::format("      '') words='{}' ;;\n", words_text(subcommands(commands)));
  for (std::size_t i = 1; i < commands.size(); ++i)
    script += fmt::format("      {}) words='{}' from={} ;;\n", commands[i].name,
                          words_text(commands[i].words), commands[i].files ? "file" : "none");
  script += R"(    esac
  fi
  [ -z "$list" ] || before=${current%"${current##*,}"}
  mapfile -t COMPREPLY < <(compgen -P "$option$before" -W "$words" -- "${current#"$before"}")
  case $from in
    file) mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -P "$option" -f -- "$current") && compopt -o filenames 2>/dev/null ;;
    folder) mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -P "$option" -d -- "$current") && compopt -o filenames 2>/dev/null ;;
  esac
  current=$option$current
  for word in : =; do
    [[ $COMP_WORDBREAKS == *$word* && $current == *$word* ]] || continue
    before=${current%"${current##*"$word"}"}
    COMPREPLY=("${COMPREPLY[@]#"$before"}")
    current=${current#"$before"}
  done
  return 0
}
complete -F _penumbra penumbra
)";
  return script;
}

std::string zsh_script(const std::vector<CompletedCommand>& commands) {
  std::string script = "#compdef penumbra\n" + fmt::format(fmt::runtime(made_by), "zsh");
  script += R"(_penumbra_words() { # list|one files|none WORD...
  local kind=$1 files=$2
  shift 2
  [[ $files != files ]] || _files
  [[ $kind != list ]] || compset -P '*,'
  compadd -- "$@"
}
_penumbra() {
  local curcontext="$curcontext" state line
  local -a program commands specs
  program=(
)";
  script += zsh_specs(commands.front());
  script += "  )\n  commands=(\n";
  for (std::size_t i = 1; i < commands.size(); ++i)
    script += "    " + quoted(commands[i].name + ":" + commands[i].description) + "\n";
  script += R"(  )
  _arguments -C $program '1:subcommand:->subcommand' '*::argument:->argument'
  case $state in
    subcommand) _describe subcommand commands ;;
    argument)
      case $line[1] in
)";
  for (std::size_t i = 1; i < commands.size(); ++i) {
    const CompletedCommand& command = commands[i];
    const std::string rest = command.files           ? "'*:file:_files'"
                             : command.words.empty() ? ""
                                                     : quoted("1:word:(" + words_text(command.words) + ")");
    script +=
        fmt::format("      {})\n    specs=(\n{}    {}\n    ) ;;\n", command.name, zsh_specs(command), rest);
  }
  script += R"(      esac
      _arguments $program $specs ;;
  esac
}
if [ "$funcstack[1]" = _penumbra ]; then _penumbra "$@"; else compdef _penumbra penumbra; fi
)";
  return script;
}

std::string fish_script(const std::vector<CompletedCommand>& commands) {
  std::string script = fmt::format(fmt::runtime(made_by), "fish");
  script += "complete -c penumbra -f\n" + fish_options(commands.front(), "");
  for (std::size_t i = 1; i < commands.size(); ++i) {
    const CompletedCommand& command = commands[i];
    const std::string seen = " -n '__fish_seen_subcommand_from " + command.name + "'";
    script += "complete -c penumbra -n __fish_use_subcommand -a " + command.name + " -d " +
              quoted(command.description) + "\n";
    script += fish_options(command, seen);
    if (command.files) script += "complete -c penumbra" + seen + " -F\n";
    if (!command.words.empty())
      script += "complete -c penumbra" + seen + " -a " + quoted(words_text(command.words)) + "\n";
  }
  return script;
}

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
