// A Diagnostic at a place of a text. Internal to this room.
#pragma once

#include <string>
#include <string_view>

#include "hlsl/diagnostic.h"
#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

// Lines too long for a screen come without their text.
hlsl::Diagnostic diagnostic_at(const std::string& file, std::string_view text, const Place& place,
                               hlsl::Severity severity, const std::string& message);

}  // namespace penumbra::shaderlab
