// penumbra validate: every technique, keyword set and target; or shader files of your own.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <thread>

#include "cli/report_output.h"
#include "cli/subcommand.h"
#include "input/input_error.h"
#include "input/nearest_name.h"
#include "platform/data_directory.h"
#include "validation/validate_techniques.h"

namespace penumbra::cli {

namespace {

namespace fs = std::filesystem;

struct ValidateOptions {
  std::string techniques;
  std::vector<std::string> files;
  std::string entry = "Main";
  std::string stage = "fragment";
  std::vector<std::string> defines;
  std::vector<std::string> keywords;  // one set each, its keywords parted by commas
  std::vector<std::string> package_roots;
  std::vector<std::string> include_directories;
  std::vector<std::string> targets;
  ReportOptions report;
  std::string emit_parameters;
  std::string cache;
  bool no_cache = false;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
};

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find(separator, start), text.size());
    if (end > start) parts.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

shaders::PackageRoot package_root(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError("--package-root", "'" + text + "' is not NAME=DIR",
                     "for example com.unity.render-pipelines.core=/packages/core");
  shaders::PackageRoot root{text.substr(0, equals), text.substr(equals + 1)};
  if (!fs::is_directory(root.directory))
    throw EnvironmentError("package root of " + root.name + " is no folder: '" + root.directory.string() +
                           "'");
  return root;
}

std::vector<std::string> checked_targets(const std::vector<std::string>& given) {
  const std::vector<std::string> known = validation::ValidationRequest().targets;
  for (const std::string& target : given)
    if (std::find(known.begin(), known.end(), target) == known.end())
      throw InputError("--targets", "unknown target '" + target + "'", unknown_name_way_out(target, known));
  return given.empty() ? known : given;
}

void add_files(const ValidateOptions& options, validation::ValidationRequest& request) {
  for (const std::string& file : options.files) {
    validation::ShaderToValidate shader{file, options.entry, *hlsl::find_stage(options.stage), {}};
    for (const std::string& set : options.keywords) shader.keyword_sets.push_back(split(set, ','));
    if (shader.keyword_sets.empty()) shader.keyword_sets.emplace_back();
    request.files.push_back(std::move(shader));
  }
}

validation::ValidationRequest make_request(const ValidateOptions& options) {
  validation::ValidationRequest request;
  request.targets = checked_targets(options.targets);
  request.engine.jobs = options.jobs;
  request.engine.worker_arguments = {validation::worker_mode};
  if (!options.no_cache) {
    request.engine.cache = options.cache.empty() ? validation::default_cache() : fs::path(options.cache);
  }
  add_files(options, request);
  for (const std::string& define : options.defines) {
    const std::size_t equals = std::min(define.find('='), define.size());
    request.defines.emplace_back(define.substr(0, equals),
                                 equals == define.size() ? "1" : define.substr(equals + 1));
  }
  for (const std::string& root : options.package_roots) request.package_roots.push_back(package_root(root));
  const fs::path library = platform::data_directory();
  request.package_roots.push_back({"com.penumbra.shadows", library});
  for (const std::string& directory : options.include_directories) {
    if (!fs::is_directory(directory)) throw InputError("-I", "'" + directory + "' is no folder");
    request.include_directories.emplace_back(directory);
  }
  if (!options.techniques.empty() || options.files.empty())
    request.techniques = shaders::read_technique_list(options.techniques.empty()
                                                          ? library / "ShaderLibrary" / "techniques.json"
                                                          : fs::path(options.techniques));
  return request;
}

void run_validate(const ValidateOptions& options, Context& context) {
  validation::ValidationRequest request = make_request(options);
  if (!options.emit_parameters.empty()) {
    if (!request.techniques) throw InputError("--emit-parameters", "needs a technique list, not files alone");
    write_output(options.emit_parameters, shaders::emit_parameter_structs_hlsl(*request.techniques));
    return;
  }
  validation::ValidationReport report;
  {
    Progress progress(context, "validate");
    request.engine.progress = [&](std::size_t done, std::size_t total) {
      progress.update(static_cast<double>(done), static_cast<double>(total), "shaders");
    };
    report = validation::validate(request);
  }
  write_report(options.report, report, context);
}

void add_what(CLI::App& command, ValidateOptions& options) {
  command.add_option("files", options.files, "HLSL files of your own; without any, the library's techniques");
  command.add_option("--techniques", options.techniques, "Technique list; the library's without");
  command.add_option("--entry", options.entry, "Entry point of the files")->capture_default_str();
  command.add_option("--stage", options.stage, "Stage of the files")
      ->check(CLI::IsMember({"vertex", "fragment", "compute"}))
      ->capture_default_str();
  command.add_option("-D,--define", options.defines, "NAME or NAME=VALUE, for every variant")->take_all();
  command
      .add_option("--keywords", options.keywords, "One keyword set of the files: A,B; repeat for more sets")
      ->allow_extra_args(false);
  command.add_option("--package-root", options.package_roots, "NAME=DIR: where Packages/NAME/... lies")
      ->allow_extra_args(false);
  command.add_option("-I,--include", options.include_directories, "Folder to look for includes in")
      ->allow_extra_args(false);
  command.add_option("--targets", options.targets, "Of spirv, essl310, glsl450, msl23, hlsl50; all without")
      ->delimiter(',')
      ->allow_extra_args(false);
}

}  // namespace

void add_validate(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand(
      "validate", "Compile every technique, keyword set and target, and say exactly what is wrong");
  auto options = std::make_shared<ValidateOptions>();
  add_what(*command, *options);
  add_report_options(*command, options->report);
  command->add_option("--jobs", options->jobs, "Worker processes")
      ->check(CLI::Range(1U, 256U))
      ->capture_default_str();
  command->add_option("--cache", options->cache, "Folder that keeps answers between runs");
  command->add_flag("--no-cache", options->no_cache, "Keep nothing, and use nothing that was kept");
  command->add_option("--emit-parameters", options->emit_parameters,
                      "Write the techniques' parameter structs as HLSL to this file (- for standard output), "
                      "and validate nothing");
  command->footer(
      "Exit code 1 when a variant fails. msl23 and hlsl50 are emitted and not compiled: no compiler for "
      "them\n"
      "runs here. essl310 and glsl450 are compiled and linked by this machine's OpenGL driver through EGL.");
  command->callback([options, &context] { run_validate(*options, context); });
}

}  // namespace penumbra::cli
