// The names that options accept and that are too many for a line of help: scenes, techniques, GPU families,
// targets, lint rules. Used by --list-..., shell completion, and help.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace penumbra::cli {

struct KnownName {
  std::string name;
  std::string description;  // may be empty
};

struct NameKind {
  const char* placeholder;  // shown in help for the options that take such a name
  const char* flag;         // the option that prints them
  std::vector<KnownName> (*names)();
};

const std::vector<NameKind>& name_kinds();

// The option's placeholder becomes the kind's, and the subcommand has the flag that prints the names. Several
// options may take one kind.
void takes(CLI::App& command, CLI::Option* option, const char* placeholder);

}  // namespace penumbra::cli
