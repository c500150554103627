// Where a shader's text names what its module binds. Internal to this folder.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "hlsl/source_text.h"

namespace penumbra::resolve {

// "file:line" of the first file that was read and has the name, of this function and of every resource and
// uniform that the module reads.
std::map<std::string, std::string> named_places(const std::vector<std::uint32_t>& spirv,
                                                const hlsl::SourceFiles& sources,
                                                const std::string& function);

}  // namespace penumbra::resolve
