// The file that shows a compiler's crash to whoever mends the compiler. Internal to this room.
#pragma once

#include <filesystem>
#include <string>

#include "validation/unit.h"

namespace penumbra::validation {

struct Crash {
  std::string target;   // in which it came
  std::string failure;  // "crashed with SIGSEGV", or the limit
  std::string text;     // what the parser reads; empty when making it is what crashes
};

// Writes the text under a comment that says what it does, and how to see it. The file's path; empty when the
// folder cannot be written.
std::string write_reproduction(const std::filesystem::path& folder, const CompileUnit& unit,
                               const Crash& crash);

}  // namespace penumbra::validation
