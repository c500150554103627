#include <algorithm>
#include <vector>

#include "lint/stage_rules.h"

namespace penumbra::lint {
namespace {

// A value that is calculated from thread numbers in the group, from what the wave has, or from both.
struct Origin {
  bool group = false;
  bool wave = false;
};

bool is_comparison(spv::Op op) {
  return op >= spv::OpIEqual && op <= spv::OpSLessThanEqual;
}

bool is_calculation(spv::Op op) {
  return (op >= spv::OpSNegate && op <= spv::OpFMod) ||
         (op >= spv::OpShiftRightLogical && op <= spv::OpBitReverse);
}

bool passes_on(spv::Op op) {
  return op == spv::OpLoad || op == spv::OpAccessChain || op == spv::OpBitcast ||
         op == spv::OpCompositeExtract || op == spv::OpVectorShuffle || op == spv::OpCompositeConstruct;
}

bool reads_lane(spv::Op op) {
  return op == spv::OpGroupNonUniformShuffle || op == spv::OpGroupNonUniformBroadcast;
}

// The lanes of a group of one dimension are in order on the GPUs of today.
bool is_one_row(const spirv::Code& code) {
  const auto& all = code.instructions();
  return std::any_of(all.begin(), all.end(), [](const spirv::Instruction& mode) {
    return mode.op == spv::OpExecutionMode && mode.operands[1] == spv::ExecutionModeLocalSize &&
           mode.operands[3] == 1 && mode.operands[4] == 1;
  });
}

class Origins {
 public:
  explicit Origins(const spirv::Code& code) : code_(code), origins_(code.id_bound()) {
    for (const spirv::Instruction& instruction : code.instructions())
      if (instruction.op == spv::OpVariable) origins_[instruction.result] = of_built_in(instruction.result);
  }

  // Returns whether the instruction is the first to calculate with both, or reads the lane of a thread's
  // number. Instructions are visited in their order.
  bool mixes(const spirv::Instruction& instruction) {
    Origin all;
    bool mixed_before = false;
    for (const spirv::Id id : code_.ids(instruction)) {
      all.group = all.group || origins_[id].group;
      all.wave = all.wave || origins_[id].wave;
      mixed_before = mixed_before || (origins_[id].group && origins_[id].wave);
    }
    if (reads_lane(instruction.op)) return origins_[instruction.operands[2]].group;
    const bool calculates = is_calculation(instruction.op);
    if (calculates || passes_on(instruction.op)) origins_[instruction.result] = all;
    return (calculates || is_comparison(instruction.op)) && all.group && all.wave && !mixed_before;
  }

 private:
  Origin of_built_in(spirv::Id variable) const {
    switch (code_.decoration(variable, spv::DecorationBuiltIn).value_or(spv::BuiltInMax)) {
      case spv::BuiltInLocalInvocationIndex:
      case spv::BuiltInLocalInvocationId:
        return {true, false};
      case spv::BuiltInSubgroupLocalInvocationId:
      case spv::BuiltInSubgroupSize:
        return {false, true};
      default:
        return {};
    }
  }

  const spirv::Code& code_;
  std::vector<Origin> origins_;
};

}  // namespace

std::vector<hlsl::Diagnostic> lane_order_findings(const LintedCode& linted) {
  std::vector<hlsl::Diagnostic> findings;
  Origins origins(linted.code);
  const bool one_row = is_one_row(linted.code);
  for (const spirv::Function& function : linted.code.functions())
    for (const spirv::Block& block : function.blocks)
      for (std::size_t i = block.begin; i < block.end; ++i) {
        const spirv::Instruction& instruction = linted.code.instructions()[i];
        if (!origins.mixes(instruction)) continue;
        findings.push_back(finding_at(
            linted, "lane-order", instruction.place,
            {"WaveGetLaneIndex", "WaveGetLaneCount", "WaveReadLaneAt"},
            "a lane of the wave is taken for a thread of the group; HLSL does not say which thread is in "
            "which "
            "lane: count waves by an atomic in group shared memory, or exchange the values there"));
        if (one_row) findings.back().severity = hlsl::Severity::note;
      }
  return findings;
}

}  // namespace penumbra::lint
