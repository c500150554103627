// Options that would silently have no effect, which is an error or a warning.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cli/validate_options.h"
#include "project/shader_files.h"

namespace penumbra::cli {

// Throws InputError for the first of `names` that is given while `idle` says that it would have no effect.
// `because` completes "--entry has no effect ...".
void refuse_idle(const CLI::App& command, const std::vector<std::string>& names, bool idle,
                 const std::string& because);

// Those of `penumbra validate` that other options make ineffective.
void refuse_idle_options(const CLI::App& command, const ValidateOptions& options);

// Those whose effect depends only on the files: warnings, because version control hooks give the same options
// with any files.
std::vector<std::string> idle_option_warnings(const CLI::App& command, const project::ShaderFiles& files);

}  // namespace penumbra::cli
