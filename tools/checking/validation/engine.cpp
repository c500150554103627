#include "validation/engine.h"

#include <algorithm>
#include <system_error>

#include "input/input_error.h"
#include "platform/cache_folder.h"
#include "validation/answer_unit.h"
#include "validation/entry_kind.h"
#include "validation/spirv_target.h"
#include "validation/target_check.h"
#include "validation/unit_run.h"

namespace penumbra::validation {

namespace {

namespace fs = std::filesystem;

// The engine has no cache without a folder.
EngineOptions with_cache_folder(EngineOptions options) {
  if (!options.cache.empty() && !platform::make_cache_folder(options.cache)) options.cache.clear();
  return options;
}

}  // namespace

fs::path default_cache() {
  return platform::cache_directory("validation");
}

EngineRun run_units(const std::vector<CompileUnit>& units, const EngineOptions& given) {
  const EngineOptions options = with_cache_folder(given);
  UnitRun run(units, options);
  run.recall();
  run.work();
  platform::trim_cache_when_due(options.cache, entry_kinds, options.cache_limit, run.written());
  return run.take();
}

int serve_units(const std::vector<std::string>& targets_with_drivers) {
  UnitService service;
  return platform::serve_worker(
      [&](const std::string& job, platform::WorkerLink& link) { return service.answer(job, link); },
      [&](const platform::WorkerLimits& limits) {
        open_drivers(targets_with_drivers);
        if (std::find(targets_with_drivers.begin(), targets_with_drivers.end(), fxc_target) !=
            targets_with_drivers.end())
          service.start_fxc(fxc::limits_of(limits));
      });
}

}  // namespace penumbra::validation
