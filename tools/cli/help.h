// How help is laid out: each option with what it takes, its default and, below, how it is used.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace penumbra::cli {

// For the whole tree: 100 columns, descriptions that go on below themselves.
void lay_out_help(CLI::App& app);

struct Example {
  const char* command;  // "penumbra ..." as typed
  const char* meaning;  // may be empty
};

// What stands below a subcommand's options: what is worth knowing besides, examples, and the program's exit
// codes.
void end_help(CLI::App& command, const std::string& notes, const std::vector<Example>& examples);

}  // namespace penumbra::cli
