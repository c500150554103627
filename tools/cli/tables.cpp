// penumbra tables: the disk tables with their quality figures, or a noise mask with its own.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/help.h"
#include "cli/shared_options.h"
#include "cli/subcommand.h"
#include "input/input_error.h"
#include "parameters/emit_disks.h"
#include "parameters/noise_mask.h"
#include "platform/interrupt.h"

namespace penumbra::cli {

namespace {

struct TablesOptions {
  std::string format = "table";
  std::string output;
  bool generate = false;
  bool noise_mask = false;
};

std::string noise_mask_text(const TablesOptions& options) {
  if (options.format != "table" && options.format != "json")
    throw InputError("--format " + options.format, "a noise mask is printed as table or json",
                     "--format json has its values");
  const parameters::NoiseMask mask = parameters::generate_noise_mask(
      parameters::kNoiseMaskSide, parameters::kNoiseMaskSlices, platform::throw_if_interrupted);
  return options.format == "json" ? parameters::noise_mask_json(mask) : parameters::noise_mask_table(mask);
}

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
      "tables",
      "Print the Fibonacci, Vogel and Poisson sample disks, or a blue-noise mask, with quality figures");
  auto options = std::make_shared<TablesOptions>();
  add_format(*command, options->format, {"table", "json", "hlsl", "csharp", "cpp"});
  add_output_file(*command, options->output);
  command->add_flag("--generate", options->generate,
                    "Generate the Poisson disks again instead of printing the shipped ones; takes seconds");
  command
      ->add_flag("--noise-mask", options->noise_mask,
                 "Generate the spatio-temporal blue-noise mask and print it instead, as table or json; takes "
                 "seconds")
      ->excludes("--generate");
  end_help(*command, "",
           {{"penumbra tables", "how even each disk is"},
            {"penumbra tables --noise-mask", "the power of each frequency of the mask"},
            {"penumbra tables --format hlsl -o Disks.hlsl", "the tables for a shader of your own"}});
  command->callback([options] {
    check_output_file(options->output);
    write_output(options->output, options->noise_mask ? noise_mask_text(*options) : tables_text(*options));
  });
}

}  // namespace penumbra::cli
