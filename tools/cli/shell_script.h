// The completion scripts of three shells, from a plain description of the command line.
#pragma once

#include <string>
#include <vector>

namespace penumbra::cli {

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

// The first command is the program itself, whose options go with every subcommand.
std::string bash_script(const std::vector<CompletedCommand>& commands);
std::string zsh_script(const std::vector<CompletedCommand>& commands);
std::string fish_script(const std::vector<CompletedCommand>& commands);

}  // namespace penumbra::cli
