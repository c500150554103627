// A character no HLSL token begins with. The preprocessor prints "<bad token>" for it and goes on, so it is
// looked for in what was printed, and then in the line it came from. Internal to this room.
#pragma once

#include <optional>
#include <string>

#include "hlsl/diagnostic.h"
#include "hlsl/source_text.h"

namespace penumbra::shaders {

std::optional<hlsl::Diagnostic> bad_character(const std::string& preprocessed, const std::string& main_file,
                                              const hlsl::SourceFiles& sources);

}  // namespace penumbra::shaders
