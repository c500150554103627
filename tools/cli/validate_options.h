// The options of penumbra validate.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/shared_options.h"
#include "project/shader_files.h"

namespace penumbra::cli {

struct ValidateOptions {
  // These options choose what is validated.
  std::vector<std::string> places;
  std::string project;
  bool no_project = false;
  std::vector<std::string> only;
  std::vector<std::string> skip;
  std::string techniques;
  std::string entry = "Main";
  std::string stage = "fragment";
  // These options describe the surroundings of the shaders.
  std::vector<std::string> package_roots;
  std::string cginc_root;
  std::vector<std::string> include_directories;
  std::vector<std::string> defines;
  std::string unity_version;
  std::string fxc;
  bool mobile = false;
  // These options choose the variants and the targets.
  std::vector<std::string> keywords;
  std::vector<std::string> keyword_sets;
  std::string stripping;
  std::vector<std::string> used_by;
  std::vector<std::string> urp_assets;
  std::uint64_t limit = 20'000;
  std::uint64_t sample = 0;
  bool list = false;
  std::string what_if;
  std::vector<std::string> targets;
  std::string api;
  bool no_lint = false;
  std::vector<std::string> disabled_rules;
  std::optional<std::string> explain;
  bool minimise = false;
  bool packages = false;
  // These options say how the run works and what it writes.
  int jobs = 0;  // 0 means all cores
  std::string shard;
  std::string cache;
  bool no_cache = false;
  bool require_sources = false;
  std::string keep;
  std::string emit_sources;
  WorkerOptions worker;
  ReportOptions report;
};

void add_validate_options(CLI::App& command, ValidateOptions& options);

// Refuses those of `penumbra validate` that other options make ineffective.
void refuse_idle_options(const CLI::App& command, const ValidateOptions& options);

// Returns warnings about options whose effect depends only on the files: version control hooks give the same
// options with any files.
std::vector<std::string> idle_option_warnings(const CLI::App& command, const project::ShaderFiles& files);

}  // namespace penumbra::cli
