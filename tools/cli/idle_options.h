// Options that would quietly change nothing: who gives one expects something of it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cli/validate_options.h"
#include "project/shader_files.h"

namespace penumbra::cli {

// Throws InputError for the first of `names` that is given while `idle` says that it would change nothing.
// `because` completes "--entry has no effect ...".
void refuse_idle(const CLI::App& command, const std::vector<std::string>& names, bool idle,
                 const std::string& because);

// Those of `penumbra validate` whose effect other options take away.
void refuse_idle_options(const CLI::App& command, const ValidateOptions& options);

// Those whose effect depends on the files alone: warnings, because hooks of version control give the same
// options with any files.
std::vector<std::string> idle_option_warnings(const CLI::App& command, const project::ShaderFiles& files);

}  // namespace penumbra::cli
