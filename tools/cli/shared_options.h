// Options that several subcommands have, each defined once: the same name, the same syntax, the same
// description.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/subcommand.h"
#include "platform/worker_pool.h"
#include "scene/reading_process.h"
#include "shaders/compile.h"
#include "techniques/technique_list.h"
#include "validation/report.h"

namespace penumbra::cli {

CLI::Option* add_output_file(CLI::App& command, std::string& file);
CLI::Option* add_format(CLI::App& command, std::string& format, std::vector<std::string> forms);

CLI::Option* add_jobs(CLI::App& command, int& jobs);
unsigned worker_count(int jobs);  // 0: as many as the machine has cores

// Limits for the processes in which untrusted files are compiled and read.
struct WorkerOptions {
  unsigned time_limit = 30;      // seconds of processor time
  unsigned memory_limit = 2048;  // MiB
};
void add_worker_limits(CLI::App& command, WorkerOptions& options, const std::string& of_what);
platform::WorkerLimits worker_limits(const WorkerOptions& options);
// The arguments that start this program as a worker; none where there are no worker processes.
std::vector<std::string> worker_arguments(const std::string& mode);
// Returns the process in which models and pictures are read.
scene::ReadingProcess reading_process(const WorkerOptions& options);

// The option names a manifest, or the folder of a package that has some, instead of the library's own.
CLI::Option* add_technique_list_option(CLI::App& command, std::string& list);
techniques::TechniqueList chosen_technique_list(const std::string& list);

inline constexpr const char* kAll = "all";  // stands for the name of every scene or technique

CLI::Option* add_technique_option(CLI::App& command, std::vector<std::string>& techniques,
                                  const std::string& without);
CLI::Option* add_project(CLI::App& command, std::string& folder);
CLI::Option* add_fxc(CLI::App& command, std::string& location);
CLI::Option* add_cginc_root(CLI::App& command, std::string& folder);
CLI::Option* add_package_roots(CLI::App& command, std::vector<std::string>& roots);

// Throws InputError if --from is combined with an option that affects measuring, which all do except `kept`.
void refuse_beside_from(const CLI::App& command, const std::set<std::string>& kept);

// Adds -I and -D, for shaders of the user's own.
void add_source_options(CLI::App& command, std::vector<std::string>& folders,
                        std::vector<std::string>& defines);

// Output of the subcommands that produce a validation report.
struct ReportOptions {
  std::string form = "text";
  std::string output;
  std::string root;
  std::string baseline;
  bool verbose = false;
  bool werror = false;
};

// Adds --format, --output, --root, --baseline, --verbose and --werror.
void add_report_options(CLI::App& command, ReportOptions& options);

// Sets the exit code to findings if the run fails. Throws after writing if a compiler crashed on a variant: a
// script must not take a failure of the tools for an error of a shader.
// The report is compared with the baseline, if there is one.
void write_report(const ReportOptions& options, const validation::ValidationReport& report,
                  const std::optional<validation::ValidationReport>& baseline, Context& context);

// Returns the report that --baseline names, if it is given; throws InputError if it is none.
std::optional<validation::ValidationReport> read_baseline(const ReportOptions& options);

CLI::Option* add_baseline(CLI::App& command, std::string& file, const std::string& findings);

// Arguments that subcommands over shader files share: keyword sets, macros, package roots.
std::vector<std::string> parse_keyword_set(const std::string& text);        // "A,B"
std::pair<std::string, std::string> parse_define(const std::string& text);  // "NAME" or "NAME=VALUE"

// Parses "NAME=FOLDER"; throws InputError for another form, EnvironmentError when there is no such folder.
shaders::PackageRoot parse_package_root(const std::string& text);

// Throws InputError for the first of `names` that is given although it has no effect, if `idle` is true.
// `because` completes "--entry has no effect ...".
void refuse_idle(const CLI::App& command, const std::vector<std::string>& names, bool idle,
                 const std::string& because);

}  // namespace penumbra::cli
