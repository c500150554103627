// The names that options accept and that are too many for a line of help: scenes, techniques, GPU families,
// targets, lint rules. Used by --list-... and help.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace penumbra::cli {

// The option's placeholder becomes the kind's, and the subcommand has the flag that prints the names. Several
// options may take one kind.
void takes(CLI::App& command, CLI::Option* option, const char* placeholder);

}  // namespace penumbra::cli
