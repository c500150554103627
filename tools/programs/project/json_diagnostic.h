// Diagnostics about JSON files, for reports that also contain those about shaders. Internal to this folder.
#pragma once

#include <filesystem>

#include "hlsl/diagnostic.h"
#include "input/input_error.h"

namespace penumbra::project {

// `where` is "file", "file:line" or "file:line:column", as LocatedJson and JsonObject give it.
hlsl::Diagnostic diagnostic_at(const std::string& where, hlsl::Severity severity, std::string message);

// The diagnostic is about a whole file or folder, without a line.
hlsl::Diagnostic diagnostic_of(const std::filesystem::path& file, hlsl::Severity severity,
                               std::string message);

// Converts an InputError about `file`: its location, and its hint after the problem.
hlsl::Diagnostic diagnostic_from(const InputError& error, const std::filesystem::path& file,
                                 hlsl::Severity severity);

}  // namespace penumbra::project
