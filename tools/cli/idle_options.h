// Errors and warnings about options that would silently have no effect.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cli/validate_options.h"
#include "project/shader_files.h"

namespace penumbra::cli {

// Throws InputError for the first of `names` that is given although it has no effect, if `idle` is true.
// `because` completes "--entry has no effect ...".
void refuse_idle(const CLI::App& command, const std::vector<std::string>& names, bool idle,
                 const std::string& because);

// Refuses those of `penumbra validate` that other options make ineffective.
void refuse_idle_options(const CLI::App& command, const ValidateOptions& options);

// Returns warnings about options whose effect depends only on the files: version control hooks give the same
// options with any files.
std::vector<std::string> idle_option_warnings(const CLI::App& command, const project::ShaderFiles& files);

}  // namespace penumbra::cli
