#include "cli/report_output.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "cli/shared_options.h"
#include "platform/terminal.h"

namespace penumbra::cli {

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
  command.add_flag("--verbose", options.verbose, "Show every note in the text report");
}

void write_report(const ReportOptions& options, const validation::ValidationReport& report,
                  Context& context) {
  validation::ReportStyle style;
  const bool to_stdout = options.output.empty() || options.output == "-";
  style.colour = to_stdout && platform::colour_wanted_on_stdout();
  style.verbose = options.verbose;
  style.folder = std::filesystem::current_path();
  style.root = std::filesystem::absolute(options.root.empty() ? "." : options.root);
  write_output(options.output,
               validation::format_report(report, *validation::find_report_form(options.form), style));
  if (report.count(validation::VariantStatus::failed) != 0) context.exit_code = findings;
}

}  // namespace penumbra::cli
