// penumbra render: one frame as pictures, the technique beside the reference.
#include <memory>

#include "cli/study_options.h"
#include "cli/subcommand.h"
#include "platform/data_directory.h"
#include "study/picture_sheet.h"
#include "study/study.h"

namespace penumbra::cli {
namespace {

study::Subject chosen_subject(const StudyOptions& options) {
  const bool reversed_z = !options.conventional_z;
  if (!options.adapters.empty()) return study::adapter_subject(chosen_adapters(options).front(), reversed_z);
  const shaders::TechniqueList list =
      shaders::read_technique_list(platform::data_directory() / "ShaderLibrary" / "techniques.json");
  const std::string name = options.techniques.empty() ? "pcss-angular-24-16" : options.techniques.front();
  return study::technique_subject(list, name, reversed_z);
}

void render(const StudyOptions& options, const Context& context) {
  study::StudySettings settings;
  settings.scenes = chosen_scenes(options, {"contact-boxes"});
  settings.light_degrees = options.lights.empty() ? std::vector<double>{2.0} : options.lights;
  settings.frame = frame_settings(options);
  settings.reference_samples = options.reference_samples;
  settings.seed = options.seed;
  settings.noise_seeds = 1;
  settings.timing_repeats = 0;
  settings.split_error = false;
  settings.jobs = options.jobs;
  settings.cache = options.cache;
  const study::Subject subject = chosen_subject(options);
  gpu::Device device = open_device(options);

  const study::StudyOutcome outcome = study::run_study(device, {subject}, settings, study_progress(context));

  const std::filesystem::path folder = options.output.empty() ? "." : options.output;
  make_folder(folder);
  for (const study::PictureRow& row : outcome.pictures) {
    const std::string name = study::file_stem(row);
    write_picture(folder / (name + "_reference.png"), row.reference);
    write_picture(folder / (name + "_result.png"), row.result);
    write_picture(folder / (name + "_error.png"), row.error);
    write_picture(folder / (name + "_fetches.png"), row.fetches);
    write_picture(folder / (name + ".png"), study::side_by_side(row));
    write_output("", (folder / (name + ".png")).string() + "\n");
  }
}

}  // namespace

void add_render(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand("render", "Render one technique beside the ray-traced reference");
  auto options = std::make_shared<StudyOptions>();
  add_study_options(*command, *options);
  command->add_option("--technique", options->techniques, "Technique of techniques.json")
      ->expected(1)
      ->group("What to render");
  command->add_option("--adapter", options->adapters, "NAME=FILE: your own ShadowVisibility function")
      ->expected(1)
      ->group("What to render");
  command->add_option("-o,--output", options->output, "Folder for the pictures; default: this one");
  command->callback([options, &context] { render(*options, context); });
}

}  // namespace penumbra::cli
