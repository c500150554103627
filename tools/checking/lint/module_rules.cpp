#include "lint/module_rules.h"

#include <glslang/SPIRV/spirv.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>

#include "lint/arithmetic.h"
#include "lint/barriers.h"
#include "lint/control_flow.h"
#include "lint/early_return.h"
#include "lint/gradients.h"
#include "lint/indexed_write.h"
#include "lint/legalised.h"
#include "lint/resources.h"
#include "lint/suppression.h"
#include "lint/unset_values.h"
#include "spirv/code.h"

namespace penumbra::lint {

namespace {

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

// `known` has the legalised words, if available.
std::vector<hlsl::Diagnostic> legalised_findings(const ModuleToLint& module, const spirv::Module& spirv,
                                                 const spirv::Module& known) {
  std::vector<hlsl::Diagnostic> findings;
  std::optional<spirv::Module> words = known.empty() ? legalised(spirv) : simplified(known);
  if (!words) return findings;
  const spirv::Code code(std::move(*words));
  const LintedCode linted{code, module.sources, module.file};
  if (module.stage == hlsl::Stage::fragment) append(findings, gradient_findings(linted));
  if (module.stage == hlsl::Stage::compute) append(findings, barrier_findings(linted));
  append(findings, unroll_findings(linted));
  append(findings, arithmetic_findings(linted));
  append(findings, resource_findings(linted, module.stage, module.shader_target));
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

std::vector<hlsl::Diagnostic> all_findings(const ModuleToLint& module, const spirv::Module& spirv,
                                           const spirv::Module& legalised) {
  std::vector<hlsl::Diagnostic> findings;
  const spirv::Code written(spirv);
  const LintedCode linted{written, module.sources, module.file};
  append(findings, unset_values(linted));
  append(findings, early_return_findings(linted));
  append(findings, indexed_write_findings(linted));
  append(findings, is_small(written) ? legalised_findings(module, spirv, legalised)
                                     : std::vector{finding_at(
                                           linted, "not-checked", {}, {},
                                           "the shader is too large for the rules that need it inlined")});
  return findings;
}

}  // namespace

// Most modules have no finding, and debug lines, which only serve to locate findings, double the time of
// legalisation.
std::vector<hlsl::Diagnostic> module_findings(const ModuleToLint& module) {
  if (all_findings(module, without_lines(module.spirv), module.legalised).empty()) return {};
  return all_findings(module, module.spirv, {});
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
