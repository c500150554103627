#include "shaders/discards.h"

#include "shaders/debug_lines.h"
#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

std::optional<SourcePlace> first_discard(const SpirvModule& module) {
  DebugLines lines;
  std::optional<SourcePlace> found;
  spirv::for_each_instruction(module, [&](spirv::Words instruction) {
    const SourcePlace& place = lines.visit(instruction);
    const spv::Op op = spirv::opcode(instruction);
    const bool discards =
        op == spv::OpKill || op == spv::OpTerminateInvocation || op == spv::OpDemoteToHelperInvocationEXT;
    if (discards && !found) found = place;
  });
  return found;
}

}  // namespace penumbra::shaders
