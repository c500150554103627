// Reads a cost report as a baseline, and results.json of measure.
#include "cost/baseline.h"
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "study/results.h"

namespace penumbra::fuzz {

void targets::figures(std::string_view bytes) {
  static const ScratchFolder folder;
  const std::filesystem::path file = folder.write("cost.json", bytes);
  read([&] {
    const cost::CostReport report = cost::read_cost_report(file);
    require(cost::compare_with_baseline(report, report, {}, 0.0).passed(), "a report equals itself");
    const std::string written = cost::cost_json(report);
    require(cost::cost_json(cost::read_cost_report(folder.write("again.json", written))) == written,
            "a report reads as it was written");
    cost::cost_table(report);
    cost::cost_csv(report);
  });
  read([&] {
    const study::Results results = study::parse_results(bytes, "results.json");
    const std::string written = study::to_json(results);
    require(study::to_json(study::parse_results(written, "again")) == written,
            "results read as they were written");
  });
}

}  // namespace penumbra::fuzz
