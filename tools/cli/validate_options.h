// The options of penumbra validate.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/report_output.h"
#include "cli/shared_options.h"

namespace CLI {
class App;
}

namespace penumbra::cli {

struct ValidateOptions {
  // What.
  std::vector<std::string> places;
  std::string project;
  std::vector<std::string> only;
  std::vector<std::string> skip;
  std::string techniques;
  std::string entry = "Main";
  std::string stage = "fragment";
  // With what.
  std::vector<std::string> package_roots;
  std::string cginc_root;
  std::vector<std::string> include_directories;
  std::vector<std::string> defines;
  std::string unity_version;
  std::string fxc;
  bool mobile = false;
  // Which variants and targets.
  std::vector<std::string> keywords;
  std::vector<std::string> keyword_sets;
  std::string stripping;
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
  // How.
  int jobs = 0;  // 0: all cores
  std::string shard;
  std::string cache;
  bool no_cache = false;
  bool require_sources = false;
  std::string keep;
  WorkerOptions worker;
  ReportOptions report;
};

void add_validate_options(CLI::App& command, ValidateOptions& options);

}  // namespace penumbra::cli
