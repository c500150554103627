// Finds several errors in one text. Internal to this folder.
//
// glslang's HLSL parser does not recover from an error. So the code that contains the error is removed (the
// initialiser, the statement, else the body of the function), and the rest is parsed again, a bounded number
// of times. Declarations at file scope are not removed: without one, every use of it would be an error of its
// own.
#pragma once

#include <optional>
#include <vector>

#include "shaders/source_shader.h"

namespace penumbra::shaders {

struct FoundErrors {
  // The errors are in source order, at least one; those with the same text appear once.
  std::vector<hlsl::Diagnostic> errors;
  // The text without the code of the errors, if the parser accepts it and no error was left out.
  std::optional<std::string> rest{};
};

// `log` has the parser's messages about the source.
FoundErrors errors_of(const Source& source, const std::string& log, const hlsl::SourceFiles& sources);

}  // namespace penumbra::shaders
