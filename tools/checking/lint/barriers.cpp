#include "lint/barriers.h"

#include <algorithm>
#include <string>

#include "lint/divergence.h"

namespace penumbra::lint {

namespace {

bool is_barrier(const spirv::Instruction& instruction) {
  return instruction.op == spv::OpControlBarrier;
}

hlsl::Diagnostic finding_of(const LintedCode& linted, const spirv::Function& function,
                            const Divergence& divergence, const spirv::Instruction& barrier, std::size_t node,
                            std::size_t branch) {
  const bool in_loop = divergence.loop_left_by(branch, node) != no_node;
  return finding_at(linted, "divergent-barrier", barrier.place,
                    {"GroupMemoryBarrierWithGroupSync", "AllMemoryBarrierWithGroupSync",
                     "DeviceMemoryBarrierWithGroupSync"},
                    std::string("a barrier with group sync is in divergent control flow: ") +
                        (in_loop ? "the threads of a group may leave its loop at different times"
                                 : "not all threads of a group may reach it") +
                        ", by the condition" + place_of_condition(linted, function, branch, barrier.place) +
                        ": move it out of " + (in_loop ? "the loop" : "the condition") +
                        ", or make the condition one of constants and SV_GroupID");
}

}  // namespace

std::vector<hlsl::Diagnostic> barrier_findings(const LintedCode& linted) {
  std::vector<hlsl::Diagnostic> findings;
  for (const spirv::Function& function : linted.code.functions()) {
    if (function.blocks.empty() || function.blocks.size() > most_blocks) continue;
    const auto& all = linted.code.instructions();
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(function.blocks.front().begin);
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(function.blocks.back().end);
    if (std::none_of(begin, end, is_barrier)) continue;
    const Divergence divergence(linted.code, function, Together::group);
    for (const std::size_t node : divergence.flow().order) {
      const std::vector<std::size_t> branches = divergence.varying_branches_over(node);
      if (branches.empty()) continue;
      for (std::size_t i = function.blocks[node].begin; i < function.blocks[node].end; ++i)
        if (is_barrier(all[i]))
          findings.push_back(finding_of(linted, function, divergence, all[i], node, branches.back()));
    }
  }
  return findings;
}

}  // namespace penumbra::lint
