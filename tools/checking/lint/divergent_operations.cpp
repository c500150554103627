#include <algorithm>
#include <string>

#include "lint/divergence.h"
#include "lint/stage_rules.h"

namespace penumbra::lint {
namespace {

bool is_barrier(const spirv::Instruction& instruction) {
  return instruction.op == spv::OpControlBarrier;
}

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

hlsl::Diagnostic in_loop(const LintedCode& linted, const spirv::Function& function,
                         const Divergence& divergence, const Gradient& gradient, std::size_t branch) {
  const std::size_t header = divergence.loop_left_by(branch, gradient.node);
  const bool bounded =
      has_constant_bound(linted.code, function, divergence.flow(), loop_body(divergence.flow(), header));
  const spirv::Place place = gradient.place;
  hlsl::Diagnostic finding =
      finding_at(linted, "gradient-in-varying-loop", place, sampling_functions(),
                 "derivatives are taken in divergent control flow: the loop's number of iterations "
                 "differs between pixels, by the condition" +
                     place_of_condition(linted, function, branch, place) +
                     (bounded ? "; Direct3D unrolls it, elsewhere they are undefined"
                              : "; Direct3D must unroll it and finds no bound") +
                     ": use SampleLevel or SampleGrad");
  if (bounded) finding.severity = hlsl::Severity::warning;
  return finding;
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
  const auto leaving = std::find_if(branches.begin(), branches.end(), [&](std::size_t branch) {
    return divergence.loop_left_by(branch, gradient.node) != no_node;
  });
  findings.push_back(leaving == branches.end() ? under_condition(linted, function, gradient, branches.back())
                                               : in_loop(linted, function, divergence, gradient, *leaving));
}

}  // namespace

std::vector<hlsl::Diagnostic> gradient_findings(const LintedCode& linted) {
  std::vector<hlsl::Diagnostic> findings;
  for (const spirv::Function& function : linted.code.functions()) {
    if (function.blocks.empty() || function.blocks.size() > most_blocks) continue;
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

// The attribute `[unroll(8)]` is a bound; it stands in the loop's line, or the one before it.
bool names_bound(const LintedCode& linted, const spirv::Place& place) {
  for (int line = place.line; line > 0 && line > place.line - 2; --line) {
    std::string words = linted.sources.line(linted.code.file_name(place.file), line);
    std::erase(words, ' ');
    if (words.find("[unroll(") != std::string::npos) return true;
  }
  return false;
}

std::vector<hlsl::Diagnostic> unroll_findings(const LintedCode& linted) {
  std::vector<hlsl::Diagnostic> findings;
  for (const spirv::Function& function : linted.code.functions()) {
    if (function.blocks.empty() || function.blocks.size() > most_blocks) continue;
    const ControlFlow flow = control_flow(linted.code, function);
    for (const std::size_t node : flow.order) {
      const spirv::Block& block = function.blocks[node];
      if (flow.merge[node] == no_node) continue;
      const spirv::Instruction& merge = linted.code.instructions()[block.end - 2];
      if (merge.op != spv::OpLoopMerge || (merge.operands[2] & spv::LoopControlUnrollMask) == 0) continue;
      const std::vector<bool> body = loop_body(flow, node);
      if (body.empty() || has_constant_bound(linted.code, function, flow, body)) continue;
      spirv::Place place = merge.place;
      if (place.line == 0) place = linted.code.instructions()[block.begin].place;
      if (names_bound(linted, place)) continue;
      findings.push_back(finding_at(linted, "unroll-without-bound", place, {"for", "while", "do"},
                                    "[unroll] on a loop without a constant bound on its iterations: use "
                                    "[loop], or break after a constant number of iterations"));
    }
  }
  return findings;
}

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
