// The places where a shader's text names the resources that its module binds. Internal to this folder.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "hlsl/source_text.h"

namespace penumbra::resolve {

// Returns "file:line" of the first file that was read and has the name, for this function and for every
// resource and uniform that the module reads.
std::map<std::string, std::string> named_places(const std::vector<std::uint32_t>& spirv,
                                                const hlsl::SourceFiles& sources,
                                                const std::string& function);

}  // namespace penumbra::resolve
