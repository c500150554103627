// The error for a command line that cannot be parsed: the problem, the nearest valid name, how to get help.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "input/input_error.h"

namespace penumbra::cli {

// `app` is the tree whose parse() threw.
InputError usage_error(CLI::App& app, const CLI::ParseError& error);

InputError unknown_subcommand(CLI::App& app, const std::string& name);

}  // namespace penumbra::cli
