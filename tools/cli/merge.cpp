// penumbra merge: the reports of all shards of one run as one report; or one report in another form.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/help.h"
#include "cli/report_output.h"
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
  std::vector<validation::NamedReport> reports;
  for (const std::string& file : options.files) reports.push_back({file, validation::read_report_json(file)});
  write_report(options.report, validation::merge_reports(std::move(reports)), context);
}

}  // namespace

void add_merge(CLI::App& app, Context& context) {
  CLI::App* command =
      app.add_subcommand("merge", "Join the reports of all shards of one run, or put one in another form");
  auto options = std::make_shared<MergeOptions>();
  options->report.form = "json";
  command->add_option("reports", options->files, "JSON reports of penumbra validate")
      ->type_name("FILE")
      ->required();
  add_report_options(*command, options->report);
  end_help(
      *command,
      "Each shard of one request must be there just once. Exit code 1 when a variant of the merged report\n"
      "failed, as that of the run without shards.",
      {{"penumbra merge shard-1.json shard-2.json -o report.json", "one report of two shards"},
       {"penumbra merge report.json --format sarif -o report.sarif",
        "a whole run's report in another form"}});
  command->callback([options, &context] { run_merge(*options, context); });
}

}  // namespace penumbra::cli
