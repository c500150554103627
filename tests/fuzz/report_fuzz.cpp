// A report of validate, read for merge and written in every form.
#include <nlohmann/json.hpp>
#include "fuzz/fuzz_input.h"
#include "validation/report_merge.h"

namespace {

using namespace penumbra;

void write_forms(const validation::ValidationReport& report) {
  validation::ReportStyle style;
  style.root = "/home/project";
  style.folder = "/home/project/Assets";
  fuzz::require_harmless(validation::report_text(report, {false, true, {}, {}}));
  const std::string sarif = validation::report_sarif(report, style);
  fuzz::require(nlohmann::json::accept(sarif), "SARIF is JSON");
  for (const char c : validation::report_junit(report, style))
    fuzz::require(static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t', "XML's own characters");
  const std::string github = validation::report_github(report, style);
  fuzz::require_harmless(github);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::ScratchFolder folder;
  const std::filesystem::path file = folder.write("report.json", fuzz::text_of(data, size));
  fuzz::read([&] {
    const validation::ValidationReport report = validation::read_report_json(file);
    write_forms(report);
    const std::string written = validation::report_json(report);
    const validation::ValidationReport again =
        validation::read_report_json(folder.write("again.json", written));
    fuzz::require(validation::report_json(again) == written, "a report reads as it was written");
    fuzz::read([&] { validation::merge_reports({{"a", report}}); });
    fuzz::read([&] { validation::merge_reports({{"a", report}, {"b", report}}); });
  });
  return 0;
}
