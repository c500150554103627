// The layout of help: each option with its argument, its default and, below, its description.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace penumbra::cli {

// Sets the layout of the whole tree: 100 columns, descriptions wrapped below themselves.
void lay_out_help(CLI::App& app);

struct Example {
  const char* command;  // "penumbra ..." as typed
  const char* meaning;  // may be empty
};

// The text after a subcommand's options: notes, examples, and the program's exit codes.
void end_help(CLI::App& command, const std::string& notes, const std::vector<Example>& examples);

}  // namespace penumbra::cli
