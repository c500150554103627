#include "lint/module_rules.h"

#include <glslang/SPIRV/spirv.hpp>
#include <spirv-tools/optimizer.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>

#include "lint/control_flow.h"
#include "lint/stage_rules.h"
#include "lint/suppression.h"
#include "spirv/code.h"

namespace penumbra::lint {
namespace {

void legalise(spvtools::Optimizer& to) {
  to.RegisterPass(spvtools::CreateDeadBranchElimPass())
      .RegisterPass(spvtools::CreateMergeReturnPass())
      .RegisterPass(spvtools::CreateInlineExhaustivePass())
      .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
      .RegisterPass(spvtools::CreatePrivateToLocalPass())
      .RegisterPass(spvtools::CreateFixStorageClassPass())
      .RegisterPass(spvtools::CreateLocalSingleBlockLoadStoreElimPass())
      .RegisterPass(spvtools::CreateLocalSingleStoreElimPass())
      .RegisterPass(spvtools::CreateScalarReplacementPass(0))
      .RegisterPass(spvtools::CreateLocalAccessChainConvertPass())
      .RegisterPass(
          spvtools::CreateAggressiveDCEPass())  // otherwise unused access chains keep variables alive
      .RegisterPass(spvtools::CreateSSARewritePass())
      .RegisterPass(spvtools::CreateCCPPass());
}

void simplify(spvtools::Optimizer& to) {
  to.RegisterPass(spvtools::CreateDeadBranchElimPass())
      .RegisterPass(spvtools::CreateSimplificationPass())
      .RegisterPass(spvtools::CreateAggressiveDCEPass())
      .RegisterPass(spvtools::CreateCopyPropagateArraysPass())
      .RegisterPass(spvtools::CreateVectorDCEPass())
      .RegisterPass(spvtools::CreateDeadInsertElimPass())
      .RegisterPass(spvtools::CreateRedundancyEliminationPass())
      .RegisterPass(spvtools::CreateAggressiveDCEPass());
}

enum class Legalisation { done, to_do };

std::optional<std::vector<std::uint32_t>> optimised(const std::vector<std::uint32_t>& spirv,
                                                    Legalisation legalisation) {
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
  optimizer.SetMessageConsumer([](spv_message_level_t, const char*, const spv_position_t&, const char*) {});
  if (legalisation == Legalisation::to_do) legalise(optimizer);
  simplify(optimizer);
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);
  std::vector<std::uint32_t> words;
  if (!optimizer.Run(spirv.data(), spirv.size(), &words, options)) return std::nullopt;
  return words;
}

// The module as a driver sees it: one function, SSA values instead of variables, without dead code and dead
// resources, with debug lines.
//
// It is made by SPIRV-Tools' passes for HLSL legalisation without loop unrolling and without the wrapping of
// OpKill, so that loops and discards are preserved.

// Returns nothing if SPIRV-Tools fails.
std::optional<std::vector<std::uint32_t>> legalised(const std::vector<std::uint32_t>& spirv) {
  return optimised(spirv, Legalisation::to_do);
}

// Runs the remaining passes on a module that the compiler has already legalised.
std::optional<std::vector<std::uint32_t>> simplified(const std::vector<std::uint32_t>& spirv) {
  return optimised(spirv, Legalisation::done);
}

void append(std::vector<hlsl::Diagnostic>& to, std::vector<hlsl::Diagnostic> from) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

auto order_of(const hlsl::Diagnostic& finding) {
  return std::tie(finding.file, finding.line, finding.column, finding.rule, finding.message);
}

bool is_small(const spirv::Code& code) {
  std::size_t blocks = 0;
  for (const spirv::Function& function : code.functions()) blocks += function.blocks.size();
  return blocks <= most_blocks;
}

hlsl::Diagnostic too_large(const LintedCode& linted, const std::string& rules) {
  return finding_at(linted, "not-checked", {}, {}, "the shader is too large for the rules that " + rules);
}

// `inlined` is a legalised module, or nothing where SPIRV-Tools fails.
std::vector<hlsl::Diagnostic> findings_in(const ModuleToLint& module, std::optional<spirv::Module> inlined) {
  if (!inlined) return {};
  const spirv::Code code(*std::move(inlined));
  const LintedCode linted{code, module.sources, module.file};
  std::vector<hlsl::Diagnostic> findings = resource_findings(linted, module.stage, module.shader_target);
  if (!is_small(code)) {
    findings.push_back(too_large(linted, "analyse its control flow"));
    return findings;
  }
  if (module.stage == hlsl::Stage::fragment) append(findings, derivative_findings(linted));
  if (module.stage == hlsl::Stage::compute) {
    append(findings, barrier_findings(linted));
    append(findings, missing_barrier_findings(linted));
    append(findings, lane_order_findings(linted));
  }
  return findings;
}

// An inlined function causes one finding per call.
void sort_and_unify(std::vector<hlsl::Diagnostic>& findings) {
  std::stable_sort(
      findings.begin(), findings.end(),
      [](const hlsl::Diagnostic& a, const hlsl::Diagnostic& b) { return order_of(a) < order_of(b); });
  const auto last = std::unique(
      findings.begin(), findings.end(),
      [](const hlsl::Diagnostic& a, const hlsl::Diagnostic& b) { return order_of(a) == order_of(b); });
  findings.erase(last, findings.end());
}

// Returns the module without OpLine and OpNoLine.
spirv::Module without_lines(const spirv::Module& words) {
  return spirv::with_instructions(words, [](spirv::Words instruction) {
    const spv::Op op = spirv::opcode(instruction);
    return op != spv::OpLine && op != spv::OpNoLine;
  });
}

}  // namespace

// Most modules have no finding, and debug lines, which only serve to locate findings, double the time of
// legalisation.
std::vector<hlsl::Diagnostic> module_findings(const ModuleToLint& module) {
  const spirv::Code written(module.spirv);
  if (!is_small(written)) return {too_large({written, module.sources, module.file}, "need it inlined")};
  const bool any = !findings_in(module, module.legalised.empty() ? legalised(without_lines(module.spirv))
                                                                 : simplified(module.legalised))
                        .empty();
  return any ? findings_in(module, legalised(module.spirv)) : std::vector<hlsl::Diagnostic>{};
}

std::vector<hlsl::Diagnostic> with_suppressions(std::vector<hlsl::Diagnostic> findings,
                                                const hlsl::SourceFiles& sources) {
  append(findings, unknown_suppressions(sources));
  sort_and_unify(findings);
  return without_suppressed(std::move(findings), sources);
}

std::vector<hlsl::Diagnostic> lint_module(const ModuleToLint& module) {
  return with_suppressions(module_findings(module), module.sources);
}

}  // namespace penumbra::lint
