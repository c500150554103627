// A count of the variants that only one of the two compilers refuses: FXC, which decides in Unity, or
// glslang, from whose SPIR-V all targets but d3d11 are made. Internal to this folder.
#pragma once

#include <cstddef>
#include <string>

#include "validation/report.h"

namespace penumbra::validation {

struct FrontEnds {
  std::size_t compared = 0;       // variants that both compiled or refused
  std::size_t both = 0;           // refused by both
  std::size_t fxc_alone = 0;      // refused by FXC alone
  std::size_t glslang_alone = 0;  // refused by glslang alone: Unity would compile them for Direct3D
};

// Returns zeros where the report has results of one compiler only.
FrontEnds front_ends(const ValidationReport& report);

// Returns one line for a report; empty where nothing was compared.
std::string text_of(const FrontEnds& counts);

}  // namespace penumbra::validation
