// The source line of each instruction, in a module with debug lines. Internal to this folder.
#pragma once

#include <map>
#include <string>

#include "spirv/words.h"

namespace penumbra::shaders {

// OpLine applies up to the next one, or to the end of the block (SPIR-V specification, 3.52.3).
class DebugLines {
 public:
  // Must be called for every instruction in order; returns its location.
  const SourcePlace& visit(spirv::Words instruction) {
    const spv::Op op = spirv::opcode(instruction);
    if (op == spv::OpString && instruction.size() > 2)
      strings_[instruction[1]] = spirv::literal_text(instruction.subspan(2));
    if (op == spv::OpLine && instruction.size() > 2)
      place_ = {strings_[instruction[1]], static_cast<int>(instruction[2])};
    if (op == spv::OpNoLine || op == spv::OpLabel || op == spv::OpFunctionEnd) place_ = {};
    return place_;
  }

 private:
  std::map<std::uint32_t, std::string> strings_;
  SourcePlace place_;
};

}  // namespace penumbra::shaders
