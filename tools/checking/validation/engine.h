// Runs units: from the cache if their sources are unchanged, otherwise in worker processes, each text and
// each module once.
//
// Results do not depend on the number of jobs, on the cache, or on whether processes are used: only `cached`
// and the time do. A unit that crashes, hangs or exhausts memory in a compiler fails in the target that
// causes it, with the signal or the limit in its message and the text that reproduces it in a file; all other
// units and targets get their results. Such failures are not cached.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "platform/worker_pool.h"
#include "validation/shard.h"
#include "validation/unit.h"

namespace penumbra::validation {

// The program is started as a worker of run_units() with this argument, followed by the targets whose drivers
// it opens. It passes the targets to serve_units().
inline constexpr const char* worker_mode = "validation-worker";

struct EngineOptions {
  unsigned jobs = 1;
  Shard shard;
  // The folder of the cache; if empty, there is no cache. default_cache() is the program's own.
  std::filesystem::path cache;
  std::uint64_t cache_limit = std::uint64_t{512} << 20;  // bytes; the entries used longest ago go first
  // The arguments that start this program as a worker: {worker_mode} for a program whose main() knows it.
  // Without any, threads do the work, and a crash ends the program.
  std::vector<std::string> worker_arguments;
  platform::WorkerLimits limits;
  Sharing sharing = Sharing::everything;
  bool drivers = true;  // emitted GLSL and ESSL goes to this machine's GL driver
  // The folder for texts that crash a compiler. If empty, it is below the cache, or without a cache a new one
  // for temporary files.
  std::filesystem::path keep;
  std::function<void(std::size_t done, std::size_t total)> progress;  // called by one thread at a time
  // Called likewise with the text that is emitted for a unit and a target, or with the bytes of its SPIR-V.
  // Then each unit is compiled by itself, and nothing comes from the cache or goes there.
  std::function<void(const CompileUnit& unit, const std::string& target, std::string_view text)> emitted;
};

struct EngineRun {
  std::vector<UnitResult> results;  // results of the shard's units, in their order
  std::size_t unique_texts = 0;     // distinct texts among them
  std::size_t unique_modules = 0;   // different SPIR-V modules
  std::size_t compiled = 0;         // texts that were compiled in this run, neither shared nor cached
  std::size_t damaged_entries = 0;  // damaged cache entries: detected, ignored and written again
};

std::filesystem::path default_cache();  // Returns "validation" in platform::cache_directory().

// Throws InputError when a unit's own file cannot be read or the cache's folder cannot be made,
// EnvironmentError if a driver or the worker processes are not available, and platform::Interrupted.
EngineRun run_units(const std::vector<CompileUnit>& units, const EngineOptions& options);

// Runs the worker's side; returns the exit code of the process.
int serve_units(const std::vector<std::string>& targets_with_drivers);

}  // namespace penumbra::validation
