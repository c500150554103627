// A Diagnostic at a location in a text. Internal to this folder.
#pragma once

#include <string>
#include <string_view>

#include "hlsl/diagnostic.h"
#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

// Lines that are too long for a screen are omitted.
hlsl::Diagnostic diagnostic_at(const std::string& file, std::string_view text, const Place& place,
                               hlsl::Severity severity, const std::string& message);

}  // namespace penumbra::shaderlab
