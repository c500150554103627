#include "cost/spirv_counts.h"

#include <glslang/SPIRV/spirv.hpp>
#include <spirv-tools/libspirv.hpp>
#include <stdexcept>
#include <string>

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

struct Walk {
  SpirvCounts counts;
  bool in_function = false;
};

spv_result_t visit(void* user_data, const spv_parsed_instruction_t* instruction) {
  Walk& walk = *static_cast<Walk*>(user_data);
  const auto op = static_cast<spv::Op>(instruction->opcode);
  if (op == spv::OpFunction) walk.in_function = true;
  if (op == spv::OpFunctionEnd) walk.in_function = false;
  if (!walk.in_function || is_declaration(op)) return SPV_SUCCESS;
  SpirvCounts& counts = walk.counts;
  ++counts.instructions;
  counts.alu += is_alu(op) ? 1 : 0;
  counts.texture += is_texture(op) ? 1 : 0;
  counts.memory += is_memory(op) ? 1 : 0;
  counts.control += is_control(op) ? 1 : 0;
  return SPV_SUCCESS;
}

}  // namespace

SpirvCounts count_spirv(const std::vector<std::uint32_t>& spirv) {
  Walk walk;
  const spvtools::Context context(SPV_ENV_VULKAN_1_1);
  spv_diagnostic diagnostic = nullptr;
  const spv_result_t result =
      spvBinaryParse(context.CContext(), &walk, spirv.data(), spirv.size(), nullptr, visit, &diagnostic);
  const std::string reason = diagnostic == nullptr ? "no SPIR-V" : diagnostic->error;
  spvDiagnosticDestroy(diagnostic);
  if (result != SPV_SUCCESS) throw std::invalid_argument(reason);
  return walk.counts;
}

}  // namespace penumbra::cost
