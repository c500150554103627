// Compiles techniques and files and measures every distinct module for every family.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cost/cost_report.h"
#include "hlsl/diagnostic.h"
#include "platform/worker_pool.h"
#include "shaders/compile.h"
#include "techniques/technique_list.h"

namespace penumbra::cost {

// An .hlsl file, whose entry point and stage are given, or a .shader or .compute, whose pragmas name them.
struct ShaderFile {
  std::filesystem::path file;
  std::string entry = "Main";
  hlsl::Stage stage = hlsl::Stage::fragment;
  // If empty, the first variant that the file's pragmas make is measured.
  std::vector<std::vector<std::string>> keyword_sets{};
};

struct CostRequest {
  // Every technique of the list is measured as the fragment shader that `penumbra validate` compiles: its
  // resolve function with its parameters as uniforms, for every keyword set.
  std::optional<techniques::TechniqueList> techniques;
  std::vector<ShaderFile> files;
  std::vector<std::pair<std::string, std::string>> defines;
  std::vector<shaders::PackageRoot> package_roots;
  std::vector<std::filesystem::path> include_directories;
  std::vector<std::string> families;
  // These arguments start this program as serve_compiler(); if there are none, threads compile.
  std::vector<std::string> compiler;
  platform::WorkerLimits compiler_limits;        // limits for one source
  std::filesystem::path worker;                  // see NullRadv::worker
  std::chrono::milliseconds time_limit{60'000};  // limit for one shader
  unsigned jobs = 1;
  std::function<void(std::size_t done, std::size_t total)> progress;  // called by one thread at a time
};

struct CostOutcome {
  CostReport report;  // rows by family, then in the order of the request
  // Errors of shaders that do not compile and have no row; warnings about stages that are not measured.
  std::vector<hlsl::Diagnostic> diagnostics;
};

// Opens the request's families. Throws InputError for an unknown one, EnvironmentError where one needs RADV
// or FXC and that is not installed.
std::vector<RadvFamily> open_families(const CostRequest& request);
std::string driver_of(const std::vector<RadvFamily>& families);  // RADV, or FXC without it

// Throws as open_families(), InputError for a file that cannot be read, and platform::Interrupted. A driver's
// failure on a single shader is recorded in its row.
CostOutcome measure_cost(const CostRequest& request);

}  // namespace penumbra::cost
