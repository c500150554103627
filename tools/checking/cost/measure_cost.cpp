#include "cost/measure_cost.h"

#include <algorithm>
#include <mutex>

#include "cost/cost_modules.h"
#include "cost/worker_threads.h"
#include "shaders/compiler_version.h"

namespace penumbra::cost {
namespace {

constexpr std::size_t kLargestBatch = 12;

std::vector<CostRow> empty_rows(const CostRequest& request, const std::vector<CostModule>& modules) {
  std::vector<CostRow> rows;
  for (const std::string& family : request.families)
    for (const CostModule& module : modules)
      rows.push_back({family,
                      module.file,
                      module.entry,
                      hlsl::stage_name(module.stage),
                      module.variants,
                      module.counts,
                      {}});
  return rows;
}

}  // namespace

CostOutcome measure_cost(const CostRequest& request) {
  CostOutcome outcome;
  for (const std::string& family : request.families)
    outcome.report.families.push_back(open_family({family, request.worker, request.time_limit}));
  if (!outcome.report.families.empty()) outcome.report.driver = outcome.report.families.front().driver;
  outcome.report.compiler = shaders::compiler_version();

  CostModules compiled = compile_modules(request);
  outcome.diagnostics = std::move(compiled.diagnostics);
  const std::vector<CostModule>& modules = compiled.modules;
  std::vector<CostRow>& rows = outcome.report.rows;
  rows = empty_rows(request, modules);

  // Modules of one family by the batch: the driver takes longer to start than most of them to compile.
  const std::size_t largest = std::clamp<std::size_t>(rows.size() / request.jobs, 1, kLargestBatch);
  std::vector<std::vector<std::size_t>> batches;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i % modules.size() == 0 || batches.back().size() == largest) batches.emplace_back();
    batches.back().push_back(i);
  }
  std::mutex mutex;
  std::size_t done = 0;
  run_all(batches.size(), request.jobs, [&](std::size_t batch) {
    std::vector<ModuleToMeasure> measured;
    for (const std::size_t i : batches[batch]) {
      const CostModule& module = modules[i % modules.size()];
      measured.push_back({module.spirv, module.stage, module.entry});
    }
    const std::string& family = rows[batches[batch].front()].family;
    std::vector<Measurement> results = measure({family, request.worker, request.time_limit}, measured);
    const std::lock_guard<std::mutex> lock(mutex);
    for (std::size_t k = 0; k < results.size(); ++k) rows[batches[batch][k]].measured = std::move(results[k]);
    done += results.size();
    if (request.progress) request.progress(done, rows.size());
  });
  return outcome;
}

}  // namespace penumbra::cost
