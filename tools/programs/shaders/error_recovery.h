// Finds several errors in one text. Internal to this room.
//
// glslang's HLSL parser does not recover from an error. So the code that contains the error is removed (the
// initialiser, the statement, else the body of the function), and the rest is parsed again, a bounded number
// of times. Declarations at file scope are not removed: without one, every use of it would be an error of its
// own.
#pragma once

#include <string>
#include <vector>

#include "shaders/source_shader.h"

namespace penumbra::shaders {

// In source order, at least one. `log`: the parser's messages about the source. Errors with the same text are
// reported once.
std::vector<hlsl::Diagnostic> errors_of(const Source& source, const std::string& log,
                                        const hlsl::SourceFiles& sources);

}  // namespace penumbra::shaders
