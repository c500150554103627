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

// An .hlsl file, of which entry point and stage are given, or a .shader or .compute, whose pragmas name them.
struct ShaderFile {
  std::filesystem::path file;
  std::string entry = "Main";
  hlsl::Stage stage = hlsl::Stage::fragment;
  // Without one: the first variant that the file's pragmas make.
  std::vector<std::vector<std::string>> keyword_sets{};
};

struct CostRequest {
  // Every technique of the list as the fragment shader that `penumbra validate` compiles: its resolve
  // function with its parameters as uniforms, for every keyword set.
  std::optional<techniques::TechniqueList> techniques;
  std::vector<ShaderFile> files;
  std::vector<std::pair<std::string, std::string>> defines;
  std::vector<shaders::PackageRoot> package_roots;
  std::vector<std::filesystem::path> include_directories;
  std::vector<std::string> families;
  std::vector<std::string> compiler;  // arguments that start this program as serve_compiler(); none: threads
  platform::WorkerLimits compiler_limits;        // of one source
  std::filesystem::path worker;                  // as in NullRadv
  std::chrono::milliseconds time_limit{60'000};  // of one shader
  unsigned jobs = 1;
  std::function<void(std::size_t done, std::size_t total)> progress;  // called by one thread at a time
};

struct CostOutcome {
  CostReport report;                          // rows by family, then in the order of the request
  std::vector<hlsl::Diagnostic> diagnostics;  // errors: of shaders that do not compile and have no row;
                                              // warnings: of stages not measured
};

// Of the request's families. Throws InputError for an unknown one, EnvironmentError where one needs RADV or
// FXC and that is not at hand.
std::vector<RadvFamily> open_families(const CostRequest& request);
std::string driver_of(const std::vector<RadvFamily>& families);  // RADV, or FXC without it

// Throws as open_families(), InputError for a file that cannot be read,
// platform::Interrupted. A driver's failure on a single shader is recorded in its row.
CostOutcome measure_cost(const CostRequest& request);

}  // namespace penumbra::cost
