// Parses the program's command line without its work: what parsing alone refuses.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "cli/command_line.h"

namespace penumbra::cli {

class ParseOnly {
 public:
  ParseOnly() : app_(command_line(context_)) {
    // The command ends after a subcommand's own checks, and before its work.
    for (CLI::App* command : shown_subcommands(*app_)) {
      command->parse_complete_callback([this] {
        if (const auto unexpected = app_->remaining(true); !unexpected.empty())
          throw CLI::ExtrasError(unexpected);
        throw CLI::Success();
      });
    }
  }

  // Refuses the arguments as typed, without the program's name; empty where they parse.
  std::string refusal(std::vector<std::string> arguments) {
    std::reverse(arguments.begin(), arguments.end());
    try {
      app_->parse(arguments);
    } catch (const CLI::Success&) {
      return "";
    } catch (const CLI::ParseError& error) {
      return error.what();
    }
    return "no subcommand";
  }

  CLI::App& app() { return *app_; }

 private:
  Context context_;
  std::unique_ptr<CLI::App> app_;
};

// The words of a command as a shell parts them: quotes keep blanks, a # that begins a word begins a comment,
// and | > ) end the command.
inline std::vector<std::string> words_of(const std::string& command) {
  std::vector<std::string> words(1);
  char quote = '\0';
  bool escaped = false;
  for (const char c : command) {
    if (escaped) {
      words.back() += c;
      escaped = false;
    } else if (quote == '\0' && c == '\\') {
      escaped = true;
    } else if (quote != '\0') {
      if (c == quote) {
        quote = '\0';
      } else {
        words.back() += c;
      }
    } else if (c == '\'' || c == '"') {
      quote = c;
    } else if (c == '|' || c == '>' || c == ')' || (words.back().empty() && c == '#')) {
      break;
    } else if (c == ' ' || c == '\n') {
      if (!words.back().empty()) words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

}  // namespace penumbra::cli
