// A cost report as a baseline, and results.json of measure.
#include "cost/baseline.h"
#include "fuzz/fuzz_input.h"
#include "study/results.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penumbra;
  static const fuzz::ScratchFolder folder;
  const std::string_view text = fuzz::text_of(data, size);
  const std::filesystem::path file = folder.write("cost.json", text);
  fuzz::read([&] {
    const cost::CostReport report = cost::read_cost_report(file);
    fuzz::require(cost::compare_with_baseline(report, report, {}, 0.0).passed(), "a report equals itself");
    const std::string written = cost::cost_json(report);
    fuzz::require(cost::cost_json(cost::read_cost_report(folder.write("again.json", written))) == written,
                  "a report reads as it was written");
    cost::cost_table(report);
    cost::cost_csv(report);
  });
  fuzz::read([&] {
    const study::Results results = study::parse_results(text, "results.json");
    const std::string written = study::to_json(results);
    fuzz::require(study::to_json(study::parse_results(written, "again")) == written,
                  "results read as they were written");
  });
  return 0;
}
