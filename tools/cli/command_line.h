// The program's command line as a CLI11 option tree, and one run of it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/subcommand.h"

namespace penumbra::cli {

// Returns every subcommand with its options. The tree refers to the context, which must outlive it.
std::unique_ptr<CLI::App> command_line(Context& context);

// Returns the subcommands for users: without those of worker processes.
std::vector<CLI::App*> shown_subcommands(CLI::App& app);

// Parses and runs; returns the exit code. Help and requested output go to standard output, errors to standard
// error. `arguments` are as typed, without the program's name.
int run_command_line(const std::vector<std::string>& arguments);

}  // namespace penumbra::cli
