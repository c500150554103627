// Several errors of one text. Internal to this room.
//
// glslang's HLSL parser does not recover from an error. So what holds the error is taken out (the
// initialiser, the statement, else the body of the function), and the rest is parsed again, a bounded number
// of times. Declarations at file scope are left alone: without one, every use of it would be an error of its
// own.
#pragma once

#include <string>
#include <vector>

#include "shaders/source_shader.h"

namespace penumbra::shaders {

// In the order of the text, at least one. `log`: what the parser said of the source. Errors with the same
// words are reported once.
std::vector<hlsl::Diagnostic> errors_of(const Source& source, const std::string& log,
                                        const hlsl::SourceFiles& sources);

}  // namespace penumbra::shaders
