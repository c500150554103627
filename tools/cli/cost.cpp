// penumbra cost: the cost of every technique, or of your own shader files, on AMD GPUs, without one.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>

#include "cli/help.h"
#include "cli/known_names.h"
#include "cli/option_text.h"
#include "cli/option_values.h"
#include "cli/shared_options.h"
#include "cli/subcommand.h"
#include "cost/baseline.h"
#include "cost/families.h"
#include "cost/measure_cost.h"
#include "cost/module_compiler.h"
#include "cost/null_radv.h"
#include "fxc/fxc.h"
#include "input/input_error.h"
#include "input/visible_text.h"
#include "platform/data_directory.h"
#include "platform/terminal.h"
#include "project/shader_files.h"
#include "shaders/compile.h"

namespace penumbra::cli {

namespace {

namespace fs = std::filesystem;

struct CostOptions {
  std::vector<std::string> files;
  std::vector<std::string> techniques;
  std::string technique_list;
  std::vector<std::string> families;
  std::string fxc;
  std::string entry = "Main";
  std::string stage = "fragment";
  std::vector<std::string> defines;
  std::vector<std::string> keywords;  // each is one set, its keywords separated by commas
  std::vector<std::string> package_roots;
  std::vector<std::string> include_directories;
  std::string format = "table";
  std::string output;
  std::string baseline;
  double tolerance = 0.0;
  bool any_driver = false;
  std::string from;  // earlier JSON; if given, nothing is measured
  int jobs = 0;      // 0 means all cores
  WorkerOptions worker{.time_limit = 60};
};

std::vector<std::string> each_once(const std::vector<std::string>& names) {
  std::vector<std::string> unique;
  for (const std::string& name : names)
    if (std::find(unique.begin(), unique.end(), name) == unique.end()) unique.push_back(name);
  return unique;
}

std::vector<std::string> families_of(const CostOptions& options) {
  if (!options.families.empty()) return each_once(options.families);
  std::vector<std::string> families = cost::default_families();
  if (fxc::find_fxc().found) families.emplace_back(cost::direct3d_family.name);
  return families;
}

// A baseline may come from a machine with or without FXC: only the families that both have are compared.
std::vector<std::string> compared_families(const CostOptions& options, const cost::CostReport& baseline) {
  if (!options.from.empty() || !options.families.empty()) return options.families;
  std::vector<std::string> families = families_of(options);
  std::erase_if(families, [&baseline](const std::string& name) {
    return std::none_of(baseline.families.begin(), baseline.families.end(),
                        [&](const cost::RadvFamily& family) { return family.name == name; });
  });
  return families;
}

void add_techniques(const CostOptions& options, cost::CostRequest& request) {
  if (!options.files.empty() && options.techniques.empty() && options.technique_list.empty()) return;
  request.techniques = chosen_technique_list(options.technique_list);
  if (options.techniques.empty()) return;
  std::vector<techniques::Technique> chosen;
  for (const std::string& name : each_once(options.techniques))
    chosen.push_back(request.techniques->find(name));
  request.techniques->techniques = std::move(chosen);
}

cost::CostRequest make_request(const CostOptions& options) {
  cost::CostRequest request;
  const fs::path library = platform::data_directory();
  add_techniques(options, request);
  for (const std::string& file : options.files) {
    project::require_shader_file(file);
    cost::ShaderFile shader{file, options.entry, *hlsl::find_stage(options.stage), {}};
    for (const std::string& set : options.keywords) shader.keyword_sets.push_back(parse_keyword_set(set));
    request.files.push_back(std::move(shader));
  }
  for (const std::string& define : options.defines) request.defines.push_back(parse_define(define));
  for (const std::string& root : options.package_roots)
    request.package_roots.push_back(parse_package_root(root));
  request.package_roots.push_back({"com.penumbra.shadows", library});
  for (const std::string& directory : options.include_directories) {
    if (!fs::is_directory(directory)) throw InputError("-I", "'" + directory + "' is not a folder");
    request.include_directories.emplace_back(directory);
  }
  request.families = families_of(options);
  request.compiler = worker_arguments(cost::compiler_worker_mode);
  request.compiler_limits = worker_limits(options.worker);
  request.worker = platform::program_path();
  request.time_limit = std::chrono::seconds(options.worker.time_limit);
  request.jobs = worker_count(options.jobs);
  return request;
}

// Returns the command that gives the same rows again, without this machine's folders.
std::string reproducing_command(const CostOptions& options) {
  std::string command = "penumbra cost";
  for (const std::string& file : options.files) command += " " + shell_word(file);
  const auto add = [&command](const char* name, const std::vector<std::string>& values) {
    for (const std::string& value : values) command += std::string(" ") + name + " " + shell_word(value);
  };
  if (!options.files.empty()) add("--entry", {options.entry});
  if (!options.files.empty()) add("--stage", {options.stage});
  if (!options.technique_list.empty())
    command += " --technique-list " + shell_word(fs::path(options.technique_list).filename().string());
  add("--technique", options.techniques);
  add("--family", families_of(options));
  add("--keyword-set", options.keywords);
  add("--define", options.defines);
  for (const std::string& root : options.package_roots)
    command += " --package-root " + root.substr(0, root.find('=')) + "=DIR";
  return command;
}

std::string in_form(const cost::CostReport& report, const std::string& format) {
  if (format == "json") return cost::cost_json(report);
  return format == "csv" ? cost::cost_csv(report) : cost::cost_table(report);
}

// Returns nothing if no report is to be written.
std::optional<cost::CostReport> measure(const CostOptions& options, Context& context) {
  cost::CostRequest request = make_request(options);
  cost::CostOutcome outcome;
  {
    Progress progress(context.progress(), "cost");
    request.progress = [&](std::size_t done, std::size_t total) {
      progress.update(static_cast<double>(done), static_cast<double>(total), "shaders");
    };
    outcome = cost::measure_cost(request);
  }
  for (const hlsl::Diagnostic& diagnostic : outcome.diagnostics)
    std::fprintf(stderr, "%s\n", hlsl::format(diagnostic).c_str());
  if (hlsl::has_errors(outcome.diagnostics)) context.exit_code = findings;
  // A report without the shaders that do not compile would look complete.
  if (hlsl::has_errors(outcome.diagnostics) && !options.output.empty() && options.output != "-") {
    std::fprintf(stderr, "note: %s was not written, because of these errors\n",
                 visible(options.output).c_str());
    return std::nullopt;
  }
  outcome.report.command = reproducing_command(options);
  return std::move(outcome.report);
}

// The baseline is checked before anything is measured: incomparable figures are useless.
cost::CostReport checked_baseline(const CostOptions& options) {
  cost::CostReport baseline = cost::read_cost_report(options.baseline);
  if (options.any_driver) return baseline;
  cost::CostReport ours;
  if (!options.from.empty()) {
    ours = cost::read_cost_report(options.from);
  } else {
    cost::CostRequest request;
    // One of RADV's families suffices, because all have one driver.
    for (const std::string& family : families_of(options))
      if (request.families.empty() || family == cost::direct3d_family.name)
        request.families.push_back(family);
    request.worker = platform::program_path();
    ours.families = cost::open_families(request);
    ours.driver = cost::driver_of(ours.families);
    ours.compiler = shaders::compiler_version();
  }
  cost::require_same_compilers(ours, baseline, options.baseline);
  return baseline;
}

void compare(const CostOptions& options, const cost::CostReport& report, const cost::CostReport& baseline,
             Context& context) {
  const cost::BaselineComparison comparison = cost::compare_with_baseline(
      report, baseline, {compared_families(options, baseline), options.techniques, options.files},
      options.tolerance);
  const std::string before = cost::compilers_of(baseline, report);
  const std::string now = cost::compilers_of(report, baseline);
  if (before != now)
    std::fprintf(stderr, "note: %s was measured with %s, this run with %s\n",
                 visible(options.baseline).c_str(), visible(before).c_str(), visible(now).c_str());
  if (!context.quiet || !comparison.passed())
    std::fprintf(stderr, "%s", cost::comparison_text(comparison).c_str());
  if (!comparison.passed()) context.exit_code = findings;
}

void run_cost(const CostOptions& options, Context& context) {
  if (!options.fxc.empty()) fxc::choose_fxc(options.fxc);
  check_output_file(options.output);
  refuse_report_over_source("--output", options.output);
  std::vector<std::string> inputs = options.files;
  inputs.insert(inputs.end(), {options.technique_list, options.baseline, options.from});
  refuse_input_as_output("--output", options.output, inputs);
  std::optional<cost::CostReport> baseline;
  if (!options.baseline.empty()) baseline = checked_baseline(options);
  const std::optional<cost::CostReport> report =
      options.from.empty() ? measure(options, context) : cost::read_cost_report(options.from);
  if (!report) return;
  if (report->failures() != 0) context.exit_code = findings;
  write_output(options.output, in_form(*report, options.format));
  if (baseline) compare(options, *report, *baseline, context);
}

void add_what(CLI::App& command, CostOptions& options) {
  command.add_option("files", options.files, "Your own .shader, .compute and .hlsl files")
      ->type_name("FILE")
      ->default_str("the library's techniques");
  add_technique_list_option(command, options.technique_list);
  add_technique_option(command, options.techniques, "all, without files");
  command.add_option("--entry", options.entry, "Entry point of .hlsl files")->type_name("NAME");
  command.add_option("--stage", options.stage, "Stage of .hlsl files")
      ->type_name("STAGE")
      ->check(one_of({"vertex", "fragment", "compute"}));
  one_each(command.add_option("--keyword-set", options.keywords,
                              "One keyword set of the files, as a comma-separated list"))
      ->type_name("KEYWORD[,...]")
      ->default_str("the first that the pragmas make");
  add_package_roots(command, options.package_roots);
  add_source_options(command, options.include_directories, options.defines);
  CLI::Option* family =
      as_list(command.add_option("--family", options.families,
                                 "GPU families, as Mesa names them; d3d11: the bytecode of FXC, Unity's "
                                 "compiler, as Unity's inspector counts it"));
  std::string without;
  for (const std::string& name : cost::default_families()) without += (without.empty() ? "" : ",") + name;
  family->default_str(without + "; where FXC is found also d3d11");
  takes(command, family, "FAMILY");
  add_fxc(command, options.fxc);
}

void add_comparison(CLI::App& command, CostOptions& options) {
  add_baseline(command, options.baseline, "a figure is worse");
  command.add_option("--tolerance", options.tolerance, "By how many per cent a figure may be worse")
      ->type_name("PERCENT")
      ->check(within(0, 1000));
  command.add_flag("--any-driver", options.any_driver,
                   "Compare even if the baseline was measured with other versions of driver or compiler");
}

// Adds the process that compiles shaders for a family, which `cost` starts. People do not call it, and --help
// does not list it.
void add_worker(CLI::App& app) {
  CLI::App* worker = app.add_subcommand("cost-worker", "")->group("");
  auto seconds = std::make_shared<unsigned>(60);
  worker->add_option("seconds", *seconds);
  worker->callback([seconds] { cost::run_radv_worker(*seconds, std::cin, std::cout); });
}

}  // namespace

void add_cost(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand("cost",
                                         "Report instructions, registers and cycles on AMD GPUs, from Mesa's "
                                         "compiler, and counts of Direct3D bytecode");
  auto options = std::make_shared<CostOptions>();
  add_what(*command, *options);
  add_format(*command, options->format, {"table", "json", "csv"});
  add_output_file(*command, options->output);
  add_comparison(*command, *options);
  command->add_option("--from", options->from, "Read the figures from this JSON instead of measuring")
      ->type_name("FILE")
      ->default_str("none");
  add_jobs(*command, options->jobs);
  add_worker_limits(*command, options->worker, "one shader");
  end_help(
      *command,
      "The exit code is 1 if a shader fails or a figure is worse than the baseline's, and 3 if RADV is "
      "missing, or FXC\nfor d3d11, or the baseline is from other compiler versions. The figures are static: "
      "no cache misses,\nno overdraw.",
      {{"penumbra cost", "every technique on three families"},
       {"penumbra cost --technique tent-5,tent-7 --family navi21", ""},
       {"penumbra cost My.hlsl --entry Fragment --keyword-set _A,_B --keyword-set _A", "your own file"},
       {"penumbra cost --format json -o cost.json", "a baseline to commit"},
       {"penumbra cost --baseline cost.json", "exit code 1 if a figure is worse"}});
  command->callback([command, options, &context] {
    refuse_beside_from(*command, {"files", "--technique", "--technique-list", "--family", "--fxc", "--format",
                                  "--output", "--baseline", "--tolerance", "--any-driver"});
    refuse_idle(*command, {"--entry", "--stage", "--keyword-set"}, options->files.empty(), "without a file");
    refuse_idle(*command, {"--tolerance", "--any-driver"}, options->baseline.empty(), "without --baseline");
    run_cost(*options, context);
  });
  add_worker(app);
}

}  // namespace penumbra::cli
