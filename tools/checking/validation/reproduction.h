// A file that reproduces a compiler's crash, for bug reports. Internal to this folder.
#pragma once

#include <filesystem>
#include <string>

#include "validation/unit.h"

namespace penumbra::validation {

struct Crash {
  std::string target;   // the target in which it occurred
  std::string failure;  // "crashed with SIGSEGV", or the limit
  std::string text;     // the text that the parser reads; empty if preprocessing crashes
};

// Writes the text with a comment that describes the failure and how to reproduce it. Returns the file's path;
// empty if the folder cannot be written.
std::string write_reproduction(const std::filesystem::path& folder, const CompileUnit& unit,
                               const Crash& crash);

}  // namespace penumbra::validation
