#include "cost/spirv_counts.h"

#include <stdexcept>

#include "spirv/words.h"

namespace penumbra::cost {
namespace {

bool within(spv::Op op, spv::Op first, spv::Op last) {
  return op >= first && op <= last;
}

// The specification numbers instructions group by group; the bounds below are its sections' first and last.
bool is_texture(spv::Op op) {
  return within(op, spv::OpImageSampleImplicitLod, spv::OpImageWrite) ||
         within(op, spv::OpImageQuerySizeLod, spv::OpImageQuerySamples) ||
         within(op, spv::OpImageSparseSampleImplicitLod, spv::OpImageSparseDrefGather) ||
         op == spv::OpImageSparseRead;
}

bool is_memory(spv::Op op) {
  return within(op, spv::OpImageTexelPointer, spv::OpInBoundsPtrAccessChain) ||
         within(op, spv::OpAtomicLoad, spv::OpAtomicXor);
}

bool is_control(spv::Op op) {
  return op == spv::OpPhi || op == spv::OpFunctionCall || op == spv::OpTerminateInvocation ||
         op == spv::OpDemoteToHelperInvocationEXT || within(op, spv::OpBranch, spv::OpUnreachable);
}

bool is_alu(spv::Op op) {
  return op == spv::OpExtInst || within(op, spv::OpConvertFToU, spv::OpBitcast) ||
         within(op, spv::OpSNegate, spv::OpSMulExtended) ||
         within(op, spv::OpAny, spv::OpFUnordGreaterThanEqual) ||
         within(op, spv::OpShiftRightLogical, spv::OpBitCount) ||
         within(op, spv::OpDPdx, spv::OpFwidthCoarse) ||
         within(op, spv::OpGroupNonUniformElect, spv::OpGroupNonUniformQuadSwap);
}

bool is_declaration(spv::Op op) {
  switch (op) {
    case spv::OpNop:
    case spv::OpUndef:
    case spv::OpLine:
    case spv::OpNoLine:
    case spv::OpFunction:
    case spv::OpFunctionParameter:
    case spv::OpFunctionEnd:
    case spv::OpVariable:
    case spv::OpLabel:
    case spv::OpLoopMerge:
    case spv::OpSelectionMerge:
      return true;
    default:
      return false;
  }
}

}  // namespace

SpirvCounts count_spirv(const std::vector<std::uint32_t>& spirv) {
  SpirvCounts counts;
  bool in_function = false;
  const bool whole = spirv::for_each_instruction(spirv, [&](spirv::Words instruction) {
    const spv::Op op = spirv::opcode(instruction);
    if (op == spv::OpFunction) in_function = true;
    if (op == spv::OpFunctionEnd) in_function = false;
    if (!in_function || is_declaration(op)) return;
    ++counts.instructions;
    counts.alu += is_alu(op) ? 1 : 0;
    counts.texture += is_texture(op) ? 1 : 0;
    counts.memory += is_memory(op) ? 1 : 0;
    counts.control += is_control(op) ? 1 : 0;
  });
  if (!whole || spirv.size() < spirv::header_words || spirv[0] != spv::MagicNumber)
    throw std::invalid_argument("not a SPIR-V module");
  return counts;
}

}  // namespace penumbra::cost
