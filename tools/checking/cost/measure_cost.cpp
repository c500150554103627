#include "cost/measure_cost.h"

#include <algorithm>
#include <mutex>

#include "cost/cost_modules.h"
#include "cost/families.h"
#include "cost/worker_threads.h"
#include "fxc/bytecode.h"
#include "fxc/fxc.h"
#include "shaders/compiler_version.h"

namespace penumbra::cost {
namespace {

constexpr std::size_t kLargestBatch = 12;

std::vector<CostRow> empty_rows(const std::string& family, const std::vector<CostModule>& modules) {
  std::vector<CostRow> rows;
  for (const CostModule& module : modules)
    rows.push_back({family,
                    module.file,
                    module.entry,
                    hlsl::stage_name(module.stage),
                    module.variants,
                    module.compiled.counts,
                    {}});
  return rows;
}

Measurement measurement_of(const fxc::BytecodeCost& cost) {
  Measurement measurement;
  measurement.statistics = {
      {"Instructions", cost.instructions},       {"Arithmetic instructions", cost.arithmetic},
      {"Texture instructions", cost.textures},   {"Dynamic branches", cost.branches},
      {"Temporary registers", cost.temporaries}, {"LDS size", cost.group_shared}};
  measurement.figures = figures_of(measurement.statistics);
  return measurement;
}

bool is_direct3d(const std::string& family) {
  return family == direct3d_family.name;
}

// Returns the rows of RADV's families, in the order of the request.
std::vector<CostRow> measured_by_radv(const CostRequest& request, const std::vector<std::string>& families,
                                      const std::vector<CostModule>& modules) {
  std::vector<CostRow> rows;
  for (const std::string& family : families)
    for (CostRow& row : empty_rows(family, modules)) rows.push_back(std::move(row));
  // Modules of one family run in batches, because the driver takes longer to start than most of them to
  // compile.
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
      measured.push_back({module.compiled.spirv, module.stage, module.entry});
    }
    const std::string& family = rows[batches[batch].front()].family;
    std::vector<Measurement> results = measure({family, request.worker, request.time_limit}, measured);
    const std::lock_guard<std::mutex> lock(mutex);
    for (std::size_t k = 0; k < results.size(); ++k) rows[batches[batch][k]].measured = std::move(results[k]);
    done += results.size();
    if (request.progress) request.progress(done, rows.size());
  });
  return rows;
}

std::vector<CostRow> counted_in_bytecode(const std::vector<CostModule>& modules) {
  std::vector<CostRow> rows = empty_rows(direct3d_family.name, modules);
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i].measured = measurement_of(modules[i].compiled.direct3d);
  return rows;
}

}  // namespace

std::string driver_of(const std::vector<RadvFamily>& families) {
  for (const RadvFamily& family : families)
    if (!is_direct3d(family.name)) return family.driver;
  return families.empty() ? "" : families.front().driver;
}

std::vector<RadvFamily> open_families(const CostRequest& request) {
  std::vector<RadvFamily> families;
  for (const std::string& family : request.families)
    families.push_back(is_direct3d(family) ? RadvFamily{family, direct3d_family.architecture,
                                                        fxc::name_of(fxc::require_fxc())}
                                           : open_family({family, request.worker, request.time_limit}));
  return families;
}

CostOutcome measure_cost(const CostRequest& request) {
  CostOutcome outcome;
  outcome.report.families = open_families(request);
  outcome.report.driver = driver_of(outcome.report.families);
  std::vector<std::string> of_radv = request.families;
  std::erase_if(of_radv, is_direct3d);
  // Without modules of glslang, FXC is the compiler, too.
  outcome.report.compiler = of_radv.empty() ? outcome.report.driver : shaders::compiler_version();
  std::vector<CostRow> radv;
  if (!of_radv.empty()) {
    CostModules compiled = compile_modules(request, Compiler::glslang);
    outcome.diagnostics = std::move(compiled.diagnostics);
    radv = measured_by_radv(request, of_radv, compiled.modules);
  }
  std::vector<CostRow> direct3d;
  if (of_radv.size() != request.families.size()) {
    CostModules compiled = compile_modules(request, Compiler::fxc);
    add_new(outcome.diagnostics, compiled.diagnostics);
    direct3d = counted_in_bytecode(compiled.modules);
  }
  for (const RadvFamily& family : outcome.report.families)
    for (const CostRow& row : is_direct3d(family.name) ? direct3d : radv)
      if (row.family == family.name) outcome.report.rows.push_back(row);
  return outcome;
}

}  // namespace penumbra::cost
