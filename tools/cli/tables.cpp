// penumbra tables: the disk tables with their quality figures.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/help.h"
#include "cli/shared_options.h"
#include "cli/subcommand.h"
#include "parameters/emit_disks.h"
#include "platform/interrupt.h"

namespace penumbra::cli {

namespace {

struct TablesOptions {
  std::string format = "table";
  std::string output;
  bool generate = false;
};

std::string tables_text(const TablesOptions& options) {
  const parameters::DiskSet set = parameters::disk_set(options.generate, platform::throw_if_interrupted);
  if (options.format == "json") return parameters::disks_json(set);
  if (options.format == "hlsl") return parameters::disks_source(set, parameters::Language::hlsl);
  if (options.format == "csharp") return parameters::disks_source(set, parameters::Language::csharp);
  if (options.format == "cpp") return parameters::disks_source(set, parameters::Language::cpp);
  return parameters::disks_table(set);
}

}  // namespace

void add_tables(CLI::App& app, Context& /*context*/) {
  CLI::App* command = app.add_subcommand(
      "tables", "Print the Fibonacci, Vogel and Poisson sample disks, with quality figures");
  auto options = std::make_shared<TablesOptions>();
  add_format(*command, options->format, {"table", "json", "hlsl", "csharp", "cpp"});
  add_output_file(*command, options->output);
  command->add_flag("--generate", options->generate,
                    "Generate the Poisson disks again instead of printing the shipped ones; takes seconds");
  end_help(*command, "",
           {{"penumbra tables", "how even each disk is"},
            {"penumbra tables --format hlsl -o Disks.hlsl", "the tables for a shader of your own"}});
  command->callback([options] {
    check_output_file(options->output);
    write_output(options->output, tables_text(*options));
  });
}

}  // namespace penumbra::cli
