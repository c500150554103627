// The program's command line as a tree of CLI11, and one run of it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/subcommand.h"

namespace penumbra::cli {

// Every subcommand with its options. The tree refers to the context, which has to outlive it.
std::unique_ptr<CLI::App> command_line(Context& context);

// Subcommands that are for people: not the processes that the program starts of itself.
std::vector<CLI::App*> shown_subcommands(CLI::App& app);

// Parses and runs; the exit code. Help and what was asked for go to standard output, what is wrong to
// standard error. `arguments` as typed, without the program's name.
int run_command_line(const std::vector<std::string>& arguments);

}  // namespace penumbra::cli
