#include "lint/module_rules.h"

#include <glslang/SPIRV/spirv.hpp>

#include <algorithm>
#include <cstddef>
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

using Words = std::vector<std::uint32_t>;

// `known`: the legalised words, where they are at hand.
std::vector<Finding> legalised_findings(const ModuleToLint& module, const Words& spirv, const Words& known) {
  std::vector<Finding> findings;
  std::optional<Words> words = known.empty() ? legalised(spirv) : simplified(known);
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

// The module without OpLine and OpNoLine.
Words without_lines(const Words& spirv) {
  constexpr std::size_t header = 5;
  if (spirv.size() < header) return spirv;
  Words words(spirv.begin(), spirv.begin() + header);
  words.reserve(spirv.size());
  for (std::size_t at = header; at < spirv.size();) {
    const std::size_t length = spirv[at] >> 16U;
    const std::uint32_t op = spirv[at] & 0xFFFFU;
    if (length == 0 || length > spirv.size() - at) return spirv;  // SpirvCode says what is wrong
    if (op != spv::OpLine && op != spv::OpNoLine)
      words.insert(words.end(), spirv.begin() + static_cast<std::ptrdiff_t>(at),
                   spirv.begin() + static_cast<std::ptrdiff_t>(at + length));
    at += length;
  }
  return words;
}

std::vector<Finding> all_findings(const ModuleToLint& module, const Words& spirv, const Words& legalised) {
  std::vector<Finding> findings;
  const SpirvCode written(spirv);
  const LintedCode linted{written, module.sources, module.file};
  append(findings, unset_values(linted));
  append(findings, is_small(written) ? legalised_findings(module, spirv, legalised)
                                     : std::vector{finding_at(
                                           linted, "not-checked", {}, {},
                                           "the shader is too large for the rules that need it inlined")});
  return findings;
}

}  // namespace

// Most modules have no finding, and lines, which only say where one is, double the time of legalisation.
std::vector<Finding> module_findings(const ModuleToLint& module) {
  if (all_findings(module, without_lines(module.spirv), module.legalised).empty()) return {};
  return all_findings(module, module.spirv, {});
}

std::vector<Finding> with_suppressions(std::vector<Finding> findings, const hlsl::SourceFiles& sources) {
  append(findings, unknown_suppressions(sources));
  sort_and_unify(findings);
  return without_suppressed(std::move(findings), sources);
}

std::vector<Finding> lint_module(const ModuleToLint& module) {
  return with_suppressions(module_findings(module), module.sources);
}

}  // namespace penumbra::lint
