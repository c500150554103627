#include "validation/engine.h"

#include <chrono>
#include <fstream>
#include <system_error>

#include "input/input_error.h"
#include "platform/terminal.h"
#include "validation/answer_cache.h"
#include "validation/answer_unit.h"
#include "validation/target_check.h"
#include "validation/unit_run.h"

namespace penumbra::validation {

namespace {

namespace fs = std::filesystem;

// Without a folder nothing is kept.
EngineOptions with_cache_folder(EngineOptions options) {
  std::error_code error;
  if (!options.cache.empty()) fs::create_directories(options.cache, error);
  if (error) options.cache.clear();
  return options;
}

// Looking at every entry takes time that a small run should not pay: it is done when this run alone has
// written a good part of what fits, and else once a day.
void trim_when_due(const EngineOptions& options, std::uint64_t written) {
  if (options.cache.empty() || written == 0) return;
  const fs::path stamp = options.cache / "trimmed";
  std::error_code error;
  const fs::file_time_type last = fs::last_write_time(stamp, error);
  const bool lately = !error && fs::file_time_type::clock::now() - last < std::chrono::hours(24);
  if (lately && written < options.cache_limit / 64) return;
  trim_cache(options.cache, options.cache_limit);
  std::ofstream(stamp) << "by the limit in force, at the date of this file\n";
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
  trim_when_due(options, run.written());
  return run.take();
}

int serve_units(const std::vector<std::string>& targets_with_drivers) {
  UnitService service;
  return platform::serve_worker(
      [&](const std::string& job, platform::WorkerLink& link) { return service.answer(job, link); },
      [&] { open_drivers(targets_with_drivers); });
}

}  // namespace penumbra::validation
