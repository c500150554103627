// Arguments that subcommands over shader files share: keyword sets, macros, package roots.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "shaders/compile.h"

namespace penumbra::cli {

std::vector<std::string> parse_keyword_set(const std::string& text);        // "A,B"
std::pair<std::string, std::string> parse_define(const std::string& text);  // "NAME" or "NAME=VALUE"

// Parses "NAME=FOLDER"; throws InputError for another form, EnvironmentError when there is no such folder.
shaders::PackageRoot parse_package_root(const std::string& text);

}  // namespace penumbra::cli
