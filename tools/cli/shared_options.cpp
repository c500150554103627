#include "cli/shared_options.h"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "cli/known_names.h"
#include "cli/option_values.h"
#include "hlsl/identifier.h"
#include "input/input_error.h"
#include "platform/terminal.h"
#include "techniques/generated_files.h"
#include "validation/report_baseline.h"
#include "validation/report_merge.h"

namespace penumbra::cli {

CLI::Option* add_output_file(CLI::App& command, std::string& file) {
  return command.add_option("-o,--output", file, "File to write; - is standard output")
      ->type_name("FILE")
      ->default_str("-");
}

CLI::Option* add_format(CLI::App& command, std::string& format, std::vector<std::string> forms) {
  return command.add_option("--format", format, "Output format")
      ->type_name("FORMAT")
      ->check(one_of(std::move(forms)));
}

CLI::Option* add_jobs(CLI::App& command, int& jobs) {
  return command.add_option("-j,--jobs", jobs, "Number of parallel jobs; 0: one per core")
      ->type_name("N")
      ->check(within(0, 1024));
}

unsigned worker_count(int jobs) {
  return jobs > 0 ? static_cast<unsigned>(jobs) : std::max(1U, std::thread::hardware_concurrency());
}

void add_worker_limits(CLI::App& command, WorkerOptions& options, const std::string& of_what) {
  command.add_option("--time-limit", options.time_limit, "CPU time limit for " + of_what)
      ->type_name("SECONDS")
      ->check(within(1, 3600));
  command.add_option("--memory-limit", options.memory_limit, "Memory limit of one worker process")
      ->type_name("MIB")
      ->check(within(64, 65536));
}

platform::WorkerLimits worker_limits(const WorkerOptions& options) {
  platform::WorkerLimits limits;
  limits.processor_time = std::chrono::seconds(options.time_limit);
  // A second of CPU time takes several seconds on a busy machine.
  limits.time = std::max<std::chrono::milliseconds>(limits.time, 6 * limits.processor_time);
  limits.memory = std::size_t{options.memory_limit} << 20;
  return limits;
}

std::vector<std::string> worker_arguments(const std::string& mode) {
  if (!platform::worker_processes_supported()) return {};
  return {mode};
}

scene::ReadingProcess reading_process(const WorkerOptions& options) {
  scene::ReadingProcess process;
  const std::size_t answer = process.limits.answer;
  process.arguments = worker_arguments(scene::reading_mode);
  process.limits = worker_limits(options);
  process.limits.answer = answer;
  return process;
}

CLI::Option* add_technique_list_option(CLI::App& command, std::string& list) {
  return command
      .add_option(
          "--technique-list", list,
          "A technique manifest (NAME.technique.json), or the folder of a package, whose techniques take "
          "the place of the library's, or join them if the manifest says so; a name "
          "that it lacks is the library's")
      ->type_name("FILE")
      ->default_str("the library's");
}

techniques::TechniqueList chosen_technique_list(const std::string& list) {
  if (list.empty()) return techniques::read_own_techniques();
  techniques::TechniqueList read = techniques::read_technique_list(list);
  techniques::refuse_outdated_parameters(read);
  return read;
}

CLI::Option* add_technique_option(CLI::App& command, std::vector<std::string>& techniques,
                                  const std::string& without) {
  CLI::Option* option = as_list(
      command.add_option("--technique", techniques, "Techniques of the library")->default_str(without));
  takes(command, option, "TECHNIQUE");
  return option;
}

CLI::Option* add_project(CLI::App& command, std::string& folder) {
  return command
      .add_option(
          "--project", folder,
          "Unity project: its Assets/, its Packages/ and the packages it uses; --package-root overrides")
      ->type_name("FOLDER")
      ->default_str("none");
}

CLI::Option* add_fxc(CLI::App& command, std::string& location) {
  return command
      .add_option("--fxc", location, "D3DCompiler_47.dll, which is Unity's compiler; 'off': do not use it")
      ->type_name("FILE")
      ->default_str("where scripts/setup put it, or Windows has it");
}

CLI::Option* add_cginc_root(CLI::App& command, std::string& folder) {
  return command.add_option("--cginc-root", folder, "Editor/Data/CGIncludes of a Unity editor")
      ->type_name("FOLDER")
      ->default_str("none");
}

CLI::Option* add_package_roots(CLI::App& command, std::vector<std::string>& roots) {
  return one_each(command.add_option("--package-root", roots, "Folder with the files of Packages/NAME/..."))
      ->type_name("NAME=FOLDER")
      ->default_str("none");
}

void refuse_beside_from(const CLI::App& command, const std::set<std::string>& kept) {
  if (command.get_option("--from")->count() == 0) return;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || name == "--from" || kept.count(name) != 0) continue;
    throw InputError("", "--from takes its figures from the file; " + name + " has no effect",
                     "leave out one of the two");
  }
}

void add_source_options(CLI::App& command, std::vector<std::string>& folders,
                        std::vector<std::string>& defines) {
  one_each(command.add_option("-I,--include", folders, "Folder to search for includes"))
      ->type_name("FOLDER")
      ->default_str("none");
  one_each(
      command.add_option("-D,--define", defines, "Macro to define for every variant; 1 if no value is given"))
      ->type_name("NAME[=VALUE]")
      ->default_str("none");
}

void add_report_options(CLI::App& command, ReportOptions& options) {
  std::vector<std::string> forms;
  for (const validation::ReportForm form : validation::all_report_forms)
    forms.emplace_back(validation::form_name(form));
  add_format(command, options.form, std::move(forms));
  add_output_file(command, options.output);
  command
      .add_option("--root", options.root,
                  "Folder to which file names in sarif, junit and github are relative")
      ->type_name("FOLDER")
      ->default_str("the current one");
  add_baseline(command, options.baseline, "there is an error that it lacks");
  command.add_flag("--verbose", options.verbose,
                   "Show every note, and what the baseline has, in text, sarif and github");
  command.add_flag("--werror", options.werror, "Exit code 1 for warnings, too");
}

std::optional<validation::ValidationReport> read_baseline(const ReportOptions& options) {
  if (options.baseline.empty()) return std::nullopt;
  return validation::read_report_json(options.baseline);
}

CLI::Option* add_baseline(CLI::App& command, std::string& file, const std::string& findings) {
  return command
      .add_option("--baseline", file, "Compare with the JSON of an earlier run; exit code 1 if " + findings)
      ->type_name("FILE")
      ->default_str("none");
}

void write_report(const ReportOptions& options, const validation::ValidationReport& report,
                  const std::optional<validation::ValidationReport>& baseline, Context& context) {
  validation::ReportStyle style;
  const bool to_stdout = options.output.empty() || options.output == "-";
  style.colour = to_stdout && platform::colour_wanted_on_stdout();
  style.verbose = options.verbose;
  style.werror = options.werror;
  style.folder = std::filesystem::current_path();
  style.root = std::filesystem::absolute(options.root.empty() ? "." : options.root);
  if (baseline) style.known = validation::known_findings(*baseline, style);
  write_output(options.output,
               validation::format_report(report, *validation::find_report_form(options.form), style));
  if (validation::fails(report, style)) context.exit_code = findings;
  if (baseline && (!context.quiet || context.exit_code != success))
    std::fprintf(stderr, "%s",
                 comparison_text(validation::compare_with_baseline(report, *baseline, style)).c_str());
  if (const std::string crashes = validation::crash_text(report); !crashes.empty())
    throw std::runtime_error(crashes);
}

std::vector<std::string> parse_keyword_set(const std::string& text) {
  std::vector<std::string> keywords;
  std::istringstream stream(text);
  for (std::string keyword; std::getline(stream, keyword, ',');)
    if (!keyword.empty()) keywords.push_back(keyword);
  return keywords;
}

std::pair<std::string, std::string> parse_define(const std::string& text) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string name = text.substr(0, std::min(text.find('('), equals));
  if (!hlsl::is_identifier(name))
    throw InputError(
        "-D",
        "'" + name + "' is not a macro's name, which has letters, digits and '_' and begins with no digit",
        "for example -D _QUALITY=2");
  return {text.substr(0, equals), equals == text.size() ? "1" : text.substr(equals + 1)};
}

shaders::PackageRoot parse_package_root(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError("--package-root", "'" + text + "' is not NAME=FOLDER",
                     "for example com.unity.render-pipelines.core=/packages/core");
  shaders::PackageRoot root{text.substr(0, equals), text.substr(equals + 1)};
  if (!std::filesystem::is_directory(root.directory))
    throw EnvironmentError("the package root of " + root.name + " is not a folder: '" +
                           root.directory.string() + "'");
  return root;
}

void refuse_idle(const CLI::App& command, const std::vector<std::string>& names, bool idle,
                 const std::string& because) {
  if (!idle) return;
  for (const std::string& name : names)
    if (command.get_option(name)->count() > 0)
      throw InputError("", name + " has no effect " + because, "leave it out");
}

}  // namespace penumbra::cli
