#include "validation/report.h"

#include <algorithm>

namespace penumbra::validation {

const char* status_name(VariantStatus status) {
  switch (status) {
    case VariantStatus::passed:
      return "passed";
    case VariantStatus::failed:
      return "failed";
    case VariantStatus::absent:
      return "absent";
    case VariantStatus::unreached:
      return "unreached";
    case VariantStatus::unchecked:
      break;
  }
  return "unchecked";
}

std::optional<VariantStatus> find_status(std::string_view name) {
  for (const VariantStatus status : {VariantStatus::passed, VariantStatus::failed, VariantStatus::absent,
                                     VariantStatus::unreached, VariantStatus::unchecked})
    if (name == status_name(status)) return status;
  return std::nullopt;
}

const char* form_name(ReportForm form) {
  switch (form) {
    case ReportForm::text:
      return "text";
    case ReportForm::json:
      return "json";
    case ReportForm::sarif:
      return "sarif";
    case ReportForm::junit:
      return "junit";
    case ReportForm::github:
      break;
  }
  return "github";
}

std::optional<ReportForm> find_report_form(std::string_view name) {
  for (const ReportForm form : all_report_forms)
    if (name == form_name(form)) return form;
  return std::nullopt;
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

}  // namespace penumbra::validation
