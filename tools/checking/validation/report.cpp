#include "validation/report.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "input/enumerator.h"
#include "validation/report_findings.h"
#include "validation/spirv_target.h"

namespace penumbra::validation {
namespace {

// The names are in the order of the enumerators.
constexpr std::array status_names{"passed", "failed", "absent", "unreached", "unchecked"};
constexpr std::array form_names{"text", "json", "sarif", "junit", "github"};

// The verdict of each compiler on a variant, where it is known.
struct Verdicts {
  std::optional<bool> fxc;
  std::optional<bool> glslang;
};

bool failed(const VariantRecord& record) {
  return record.status == VariantStatus::failed;
}

// Returns whether something other than a lint rule refused it.
bool refused(const VariantRecord& record) {
  return failed(record) &&
         std::any_of(record.diagnostics.begin(), record.diagnostics.end(), [](const hlsl::Diagnostic& said) {
           return said.severity == hlsl::Severity::error && said.rule.empty();
         });
}

// A compiler that crashed or reached a limit has given no verdict on the variant.
bool gave_no_verdict(const VariantRecord& record) {
  return std::any_of(record.diagnostics.begin(), record.diagnostics.end(), [](const hlsl::Diagnostic& said) {
    return said.rule == compiler_crash || said.rule == compiler_limit;
  });
}

}  // namespace

bool is_from_bytecode(const std::vector<hlsl::Diagnostic>& said) {
  return std::any_of(said.begin(), said.end(),
                     [](const hlsl::Diagnostic& one) { return one.rule == from_bytecode; });
}

const char* status_name(VariantStatus status) {
  return status_names.at(static_cast<std::size_t>(status));
}

std::optional<VariantStatus> find_status(std::string_view name) {
  return enumerator_named<VariantStatus>(name, status_names);
}

const char* form_name(ReportForm form) {
  return form_names.at(static_cast<std::size_t>(form));
}

std::optional<ReportForm> find_report_form(std::string_view name) {
  return enumerator_named<ReportForm>(name, form_names);
}

std::size_t ValidationReport::count(VariantStatus status) const {
  return static_cast<std::size_t>(std::count_if(
      records.begin(), records.end(), [&](const VariantRecord& record) { return record.status == status; }));
}

std::string format_report(const ValidationReport& report, ReportForm form, const ReportStyle& style) {
  switch (form) {
    case ReportForm::text:
      return report_text(report, style);
    case ReportForm::json:
      return report_json(report);
    case ReportForm::sarif:
      return report_sarif(report, style);
    case ReportForm::junit:
      return report_junit(report, style);
    case ReportForm::github:
      break;
  }
  return report_github(report, style);
}

FrontEnds front_ends(const ValidationReport& report) {
  const Variants variants(report);
  std::vector<Verdicts> verdicts(variants.size());
  for (std::size_t i = 0; i < report.records.size(); ++i) {
    const VariantRecord& record = report.records[i];
    if (record.target == whole_source) continue;
    if (record.status == VariantStatus::unchecked && !is_from_bytecode(record.diagnostics)) continue;
    if (gave_no_verdict(record)) continue;
    Verdicts& of_variant = verdicts[variants.of_record(i)];
    if (record.target == fxc_target)
      of_variant.fxc = !failed(record);
    else  // a target that is made from the module shows only that glslang made none
      of_variant.glslang = of_variant.glslang.value_or(true) && record.status != VariantStatus::unreached &&
                           !(is_spirv_target(record.target) && refused(record)) &&
                           !is_from_bytecode(record.diagnostics);
  }
  FrontEnds counts;
  for (const Verdicts& of_variant : verdicts) {
    if (!of_variant.fxc || !of_variant.glslang) continue;
    ++counts.compared;
    counts.both += !*of_variant.fxc && !*of_variant.glslang ? 1 : 0;
    counts.fxc_alone += !*of_variant.fxc && *of_variant.glslang ? 1 : 0;
    counts.glslang_alone += *of_variant.fxc && !*of_variant.glslang ? 1 : 0;
  }
  return counts;
}

std::string text_of(const FrontEnds& counts) {
  if (counts.compared == 0) return {};
  return "of " + counted(counts.compared, "variant") + " that both compilers read, FXC alone refuses " +
         std::to_string(counts.fxc_alone) + ", glslang alone " + std::to_string(counts.glslang_alone) +
         ", both " + std::to_string(counts.both);
}

}  // namespace penumbra::validation
