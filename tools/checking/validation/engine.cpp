#include "validation/engine.h"

#include <cctype>
#include <system_error>

#include "input/input_error.h"
#include "platform/terminal.h"
#include "validation/answer_unit.h"
#include "validation/entry_kind.h"
#include "validation/target_check.h"
#include "validation/unit_run.h"

namespace penumbra::validation {

namespace {

namespace fs = std::filesystem;

// Without a folder there is no cache.
EngineOptions with_cache_folder(EngineOptions options) {
  std::error_code error;
  if (!options.cache.empty()) fs::create_directories(options.cache, error);
  if (error) options.cache.clear();
  return options;
}

}  // namespace

fs::path default_cache() {
  return platform::cache_directory() / "validation";
}

EngineRun run_units(const std::vector<CompileUnit>& units, const EngineOptions& given) {
  const EngineOptions options = with_cache_folder(given);
  UnitRun run(units, options);
  run.recall();
  run.work();
  platform::trim_cache_when_due(options.cache, entry_kinds, options.cache_limit, run.written());
  return run.take();
}

int serve_units(std::vector<std::string> arguments) {
  UnitService service;
  // Numbers behind the targets are FXC's limits.
  std::vector<unsigned> limits;
  while (arguments.size() >= 2 && std::isdigit(static_cast<unsigned char>(arguments.back().front())) != 0) {
    limits.push_back(static_cast<unsigned>(std::stoul(arguments.back())));
    arguments.pop_back();
  }
  return platform::serve_worker(
      [&](const std::string& job, platform::WorkerLink& link) { return service.answer(job, link); },
      [&] {
        open_drivers(arguments);
        if (limits.size() == 2) service.start_fxc({limits[1], limits[0]});
      });
}

}  // namespace penumbra::validation
