// Where a SPIR-V module reads its textures: to refuse what a counting shim would not see.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace penumbra::shaders {

struct ImageInstruction {
  std::string function;  // its OpName up to the parameter list; empty when the module has no names
  std::string opcode;    // for example "OpImageSampleExplicitLod"
  std::string file{};    // where OpLine says it stands; line 0 in a module without debug lines
  int line = 0;
};

// Every sample, fetch, gather or read of an image in a function whose name does not start with `prefix`. The
// module must have kept its functions (CompileRequest::optimise off). Throws std::invalid_argument for words
// that are no SPIR-V.
std::vector<ImageInstruction> image_instructions_outside(const std::vector<std::uint32_t>& spirv,
                                                         const std::string& prefix);

}  // namespace penumbra::shaders
