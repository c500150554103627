// Lint of one compiled unit, and the data that it collects for the later lint of whole shaders
// (program_lint.h). Internal to this folder.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hlsl/source_text.h"
#include "lint/program_rules.h"
#include "validation/recent_results.h"
#include "validation/unit.h"

namespace penumbra::validation {

// Equal modules are examined once. An object is not for several threads at once.
class LintedModules {
 public:
  // `compiled` is the result with its unoptimised module, and `of_text` has the findings in its text.
  // Findings of rules that are left out are not among the messages.
  std::vector<hlsl::Diagnostic> messages(const CompileUnit& unit, const shaders::CompileResult& compiled,
                                         std::vector<hlsl::Diagnostic> of_text);

 private:
  RecentResults<std::vector<hlsl::Diagnostic>> findings_{256};
};

// Leaves the rules about Unity (lint::RuleInfo::of_unity) out.
void leave_unity_out(LintOrder& order);

bool holds_suppression(std::string_view source);  // true for a comment that silences a rule, or seems to

std::string encode(const std::vector<lint::ConstantBuffer>& buffers);
std::optional<std::vector<lint::ConstantBuffer>> decode_buffers(std::string_view bytes);

// Returns the findings whose rule is not left out.
std::vector<hlsl::Diagnostic> wanted(std::vector<hlsl::Diagnostic> findings, const LintOrder& order);

}  // namespace penumbra::validation
