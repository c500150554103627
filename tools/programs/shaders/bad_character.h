// A character with which no HLSL token begins. The preprocessor prints "<bad token>" for it and continues, so
// it is searched for in the preprocessor's output, and then in the original line. Internal to this folder.
#pragma once

#include <optional>
#include <string>

#include "hlsl/diagnostic.h"
#include "hlsl/source_text.h"

namespace penumbra::shaders {

std::optional<hlsl::Diagnostic> bad_character(const std::string& preprocessed, const std::string& main_file,
                                              const hlsl::SourceFiles& sources);

}  // namespace penumbra::shaders
