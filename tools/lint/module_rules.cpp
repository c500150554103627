#include "lint/module_rules.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>

#include "lint/arithmetic.h"
#include "lint/control_flow.h"
#include "lint/gradients.h"
#include "lint/legalised.h"
#include "lint/resources.h"
#include "lint/spirv_code.h"
#include "lint/suppression.h"
#include "lint/unset_values.h"

namespace penumbra::lint {

namespace {

void append(std::vector<Finding>& to, std::vector<Finding> from) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

auto order_of(const Finding& finding) {
  const hlsl::Diagnostic& at = finding.diagnostic;
  return std::tie(at.file, at.line, at.column, finding.rule, at.message);
}

bool is_small(const SpirvCode& code) {
  std::size_t blocks = 0;
  for (const Function& function : code.functions()) blocks += function.blocks.size();
  return blocks <= most_blocks;
}

std::vector<Finding> legalised_findings(const ModuleToLint& module) {
  std::vector<Finding> findings;
  std::optional<std::vector<std::uint32_t>> words = legalised(module.spirv);
  if (!words) return findings;
  const SpirvCode code(std::move(*words));
  const LintedCode linted{code, module.sources, module.file};
  if (module.stage == hlsl::Stage::fragment) append(findings, gradient_findings(linted));
  append(findings, unroll_findings(linted));
  append(findings, arithmetic_findings(linted));
  append(findings, resource_findings(linted, module.stage, module.shader_target));
  return findings;
}

// An inlined function speaks once for each call.
void sort_and_unify(std::vector<Finding>& findings) {
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return order_of(a) < order_of(b); });
  const auto last = std::unique(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) {
    return order_of(a) == order_of(b);
  });
  findings.erase(last, findings.end());
}

}  // namespace

std::vector<Finding> lint_module(const ModuleToLint& module) {
  std::vector<Finding> findings;
  const SpirvCode written(module.spirv);
  const LintedCode linted{written, module.sources, module.file};
  append(findings, unset_values(linted));
  append(findings, is_small(written) ? legalised_findings(module)
                                     : std::vector{finding_at(
                                           linted, "not-checked", {}, {},
                                           "the shader is too large for the rules that need it inlined")});
  append(findings, unknown_suppressions(module.sources));
  sort_and_unify(findings);
  return without_suppressed(std::move(findings), module.sources);
}

}  // namespace penumbra::lint
