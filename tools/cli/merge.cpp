// penumbra merge: the reports of all shards of one run as one report; or one report in another form.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/help.h"
#include "cli/shared_options.h"
#include "cli/subcommand.h"
#include "validation/report_merge.h"

namespace penumbra::cli {

namespace {

struct MergeOptions {
  std::vector<std::string> files;
  ReportOptions report;
};

void run_merge(const MergeOptions& options, Context& context) {
  check_output_file(options.report.output);
  refuse_input_as_output("--output", options.report.output, options.files);
  refuse_input_as_output("--output", options.report.output, {options.report.baseline});
  std::vector<validation::NamedReport> reports;
  for (const std::string& file : options.files) reports.push_back({file, validation::read_report_json(file)});
  write_report(options.report, validation::merge_reports(std::move(reports)), read_baseline(options.report),
               context);
}

}  // namespace

void add_merge(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand(
      "merge", "Merge the reports of all shards of a run, or convert a report to another format");
  auto options = std::make_shared<MergeOptions>();
  options->report.form = "json";
  command->add_option("reports", options->files, "JSON reports of penumbra validate")
      ->type_name("FILE")
      ->required();
  add_report_options(*command, options->report);
  end_help(*command,
           "Every shard of the run must be given exactly once. The exit code is 1 if a variant failed in any "
           "shard, as it\nis for a run without shards.",
           {{"penumbra merge shard-1.json shard-2.json -o report.json", "merge two shards"},
            {"penumbra merge report.json --format sarif -o report.sarif", "convert a report to SARIF"}});
  command->callback([options, &context] { run_merge(*options, context); });
}

}  // namespace penumbra::cli
