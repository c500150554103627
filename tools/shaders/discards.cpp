#include "shaders/discards.h"

#include "shaders/debug_lines.h"
#include "shaders/spirv_words.h"

namespace penumbra::shaders {

std::optional<SourcePlace> first_discard(const SpirvModule& module) {
  DebugLines lines;
  std::optional<SourcePlace> found;
  for_each_instruction(module, [&](SpirvWords instruction) {
    const SourcePlace& place = lines.visit(instruction);
    const spv::Op op = opcode(instruction);
    const bool discards =
        op == spv::OpKill || op == spv::OpTerminateInvocation || op == spv::OpDemoteToHelperInvocationEXT;
    if (discards && !found) found = place;
  });
  return found;
}

}  // namespace penumbra::shaders
