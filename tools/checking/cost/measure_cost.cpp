#include "cost/measure_cost.h"

#include <mutex>

#include "cost/cost_modules.h"
#include "cost/worker_threads.h"
#include "shaders/compiler_version.h"

namespace penumbra::cost {
namespace {

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

  std::mutex mutex;
  std::size_t done = 0;
  run_all(rows.size(), request.jobs, [&](std::size_t i) {
    const CostModule& module = modules[i % modules.size()];
    rows[i].measured = measure({rows[i].family, request.worker, request.time_limit},
                               {module.spirv, module.stage, module.entry});
    const std::lock_guard<std::mutex> lock(mutex);
    ++done;
    if (request.progress) request.progress(done, rows.size());
  });
  return outcome;
}

}  // namespace penumbra::cost
