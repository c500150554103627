#include <algorithm>
#include <string>

#include "lint/divergence.h"
#include "lint/stage_rules.h"

namespace penumbra::lint {
namespace {

hlsl::Diagnostic finding_of(const LintedCode& linted, const spirv::Function& function,
                            const Divergence& divergence, const spirv::Instruction& barrier, std::size_t node,
                            std::size_t branch) {
  const bool in_loop = divergence.loop_left_by(branch, node) != no_node;
  const bool behind = !in_loop && !divergence.flow().encloses(branch, node);  // what is left is a return
  const std::string condition = place_of_condition(linted, function, branch, barrier.place);
  return finding_at(
      linted, "divergent-barrier", barrier.place,
      {"GroupMemoryBarrierWithGroupSync", "AllMemoryBarrierWithGroupSync",
       "DeviceMemoryBarrierWithGroupSync"},
      std::string("a barrier with group sync is in divergent control flow: ") +
          (in_loop  ? "the threads of a group may leave its loop at different times, by the condition"
           : behind ? "some threads of a group may have returned before it, by the condition"
                    : "not all threads of a group may reach it, by the condition") +
          condition + ": " +
          (in_loop  ? "move it out of the loop, or make the condition one of constants and SV_GroupID"
           : behind ? "let them go on to it, and put the work of the others into a condition"
                    : "move it out of the condition, or make the condition one of constants and SV_GroupID"));
}

bool is_derivative(spv::Op op) {
  return op >= spv::OpDPdx && op <= spv::OpFwidthCoarse;
}

bool samples_implicitly(spv::Op op) {
  switch (op) {
    case spv::OpImageSampleImplicitLod:
    case spv::OpImageSampleDrefImplicitLod:
    case spv::OpImageSampleProjImplicitLod:
    case spv::OpImageSampleProjDrefImplicitLod:
    case spv::OpImageSparseSampleImplicitLod:
    case spv::OpImageSparseSampleDrefImplicitLod:
    case spv::OpImageQueryLod:
      return true;
    default:
      return false;
  }
}

std::vector<std::string> sampling_functions() {
  return {"Sample", "ddx", "ddy", "fwidth", "tex2D", "texCUBE", "tex1D", "tex3D", "tex2Dbias", "tex2Dproj"};
}

struct Gradient {
  const spirv::Instruction& instruction;
  std::size_t node = 0;
  spirv::Place place;
};

// An instruction of a function that was added to the source (TokenText::insert_without_line), which is
// inlined, has no line of its own: the call's arguments were read just before it.
spirv::Place place_of(const LintedCode& linted, std::size_t first, std::size_t at) {
  const auto& all = linted.code.instructions();
  std::size_t placed = at;
  while (placed > first && all[placed].place.line == 0) --placed;
  return all[placed].place.line == 0 ? all[at].place : all[placed].place;
}

hlsl::Diagnostic under_condition(const LintedCode& linted, const spirv::Function& function,
                                 const Gradient& gradient, std::size_t branch) {
  const bool derivative = is_derivative(gradient.instruction.op);
  const spirv::Place place = gradient.place;
  return finding_at(
      linted, "divergent-derivative", place, sampling_functions(),
      std::string(derivative ? "a derivative is taken" : "a texture is sampled with implicit derivatives") +
          " where only some pixels of a quad may be active, by the condition" +
          place_of_condition(linted, function, branch, place) +
          (derivative ? ": take it before the condition"
                      : ": sample before the condition, or use SampleLevel or SampleGrad"));
}

void check(const LintedCode& linted, const spirv::Function& function, const Divergence& divergence,
           const Gradient& gradient, std::vector<hlsl::Diagnostic>& findings) {
  const std::vector<std::size_t> branches = divergence.varying_branches_over(gradient.node);
  if (branches.empty()) return;
  const bool in_loop = std::any_of(branches.begin(), branches.end(), [&](std::size_t branch) {
    return divergence.loop_left_by(branch, gradient.node) != no_node;
  });
  if (!in_loop) findings.push_back(under_condition(linted, function, gradient, branches.back()));
}

}  // namespace

std::vector<hlsl::Diagnostic> derivative_findings(const LintedCode& linted) {
  std::vector<hlsl::Diagnostic> findings;
  for (const spirv::Function& function : linted.code.functions()) {
    if (function.blocks.empty()) continue;
    const auto& all = linted.code.instructions();
    const auto is_gradient = [](const spirv::Instruction& of) {
      return is_derivative(of.op) || samples_implicitly(of.op);
    };
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(function.blocks.front().begin);
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(function.blocks.back().end);
    if (std::none_of(begin, end, is_gradient)) continue;
    const Divergence divergence(linted.code, function, Together::quad);
    for (const std::size_t node : divergence.flow().order)
      for (std::size_t i = function.blocks[node].begin; i < function.blocks[node].end; ++i)
        if (is_gradient(all[i]))
          check(linted, function, divergence,
                {all[i], node, place_of(linted, function.blocks[node].begin, i)}, findings);
  }
  return findings;
}

std::vector<hlsl::Diagnostic> barrier_findings(const LintedCode& linted) {
  std::vector<hlsl::Diagnostic> findings;
  for (const spirv::Function& function : linted.code.functions()) {
    if (function.blocks.empty()) continue;
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
