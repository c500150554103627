// Reads a report of validate for merge, and writes it in every form.
#include <nlohmann/json.hpp>
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "validation/report_merge.h"

namespace penumbra::fuzz {

namespace {

void write_forms(const validation::ValidationReport& report) {
  validation::ReportStyle style;
  style.root = "/srv/project";
  style.folder = "/srv/project/Assets";
  validation::ReportStyle whole;
  whole.verbose = true;
  require_harmless(validation::report_text(report, whole));
  const std::string sarif = validation::report_sarif(report, style);
  require(nlohmann::json::accept(sarif), "SARIF is JSON");
  for (const char c : validation::report_junit(report, style))
    require(static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t', "XML's own characters");
  const std::string github = validation::report_github(report, style);
  require_harmless(github);
}

}  // namespace

void targets::report(std::string_view bytes) {
  static const ScratchFolder folder;
  const std::filesystem::path file = folder.write("report.json", bytes);
  read([&] {
    const validation::ValidationReport report = validation::read_report_json(file);
    write_forms(report);
    const std::string written = validation::report_json(report);
    const validation::ValidationReport again =
        validation::read_report_json(folder.write("again.json", written));
    require(validation::report_json(again) == written, "a report reads as it was written");
    read([&] { validation::merge_reports({{"a", report}}); });
    read([&] { validation::merge_reports({{"a", report}, {"b", report}}); });
  });
}

}  // namespace penumbra::fuzz
