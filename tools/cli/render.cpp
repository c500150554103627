// penumbra render: one frame as pictures, techniques beside the reference.
#include <memory>
#include <optional>

#include "cli/help.h"
#include "cli/idle_options.h"
#include "cli/lit_options.h"
#include "cli/option_values.h"
#include "cli/shared_options.h"
#include "cli/sheet_options.h"
#include "cli/study_messages.h"
#include "cli/study_options.h"
#include "cli/subcommand.h"
#include "cli/varied_subjects.h"
#include "input/input_error.h"
#include "platform/cache_folder.h"
#include "reference/trace_visibility.h"
#include "study/contact_sheet.h"
#include "study/kept_records.h"
#include "study/lit_view.h"
#include "study/picture_sheet.h"
#include "study/study.h"

namespace penumbra::cli {
namespace {

struct RenderOptions : StudyOptions {
  VariedSubjects varied;
  SheetArguments sheet;
  LitArguments lit;
};

study::StudySettings study_settings(const StudyOptions& options) {
  study::StudySettings settings;
  settings.scenes = chosen_scenes(options, {"contact-boxes"});
  settings.light_degrees = options.lights;
  drop_repetitions(settings.light_degrees);
  settings.frame = frame_settings(options);
  settings.compiler = chosen_compiler(options);
  reference::check_samples(options.reference_samples);
  settings.reference_samples = options.reference_samples;
  settings.seed = options.seed;
  settings.noise_seeds = 1;
  settings.timing_repeats = 0;
  settings.split_error = false;
  settings.bake = options.bake;
  settings.jobs = options.jobs;
  settings.cache = options.cache;
  return settings;
}

void write_rows(const std::filesystem::path& folder, const study::StudyOutcome& outcome) {
  make_folder(folder);
  for (std::size_t i = 0; i < outcome.pictures.size(); ++i) {
    const study::PictureRow& row = outcome.pictures[i];
    const std::string name = study::file_stem(row);
    write_picture(folder / (name + "_reference.png"), row.reference);
    write_picture(folder / (name + "_result.png"), row.result);
    write_picture(folder / (name + "_error.png"), row.error);
    write_picture(folder / (name + "_fetches.png"), row.fetches);
    if (!row.mask.empty()) write_picture(folder / (name + "_mask.png"), row.mask);
    write_picture(folder / (name + ".png"), study::side_by_side(row, outcome.records[i].title));
    write_output("", (folder / (name + ".png")).string() + "\n");
  }
}

void render(const CLI::App& command, const RenderOptions& options, Context& context) {
  check_cache_folder(options.cache, platform::cache_directory(), context);
  if (options.output == "-")
    throw InputError("--output", "pictures go into a folder, not to standard output",
                     "for a folder with that name write ./-");
  if (options.sheet.file.empty()) check_output_folder(options.output);
  study::StudySettings settings = study_settings(options);
  tell_notes(settings.scenes, context);
  const std::vector<study::Subject> subjects =
      varied_subjects(options, options.varied, study::light_kind(settings.scenes));
  refuse_idle_bake_options(command, subjects);
  refuse_idle(command, {"--fxc"}, options.front_end == "glslang", "without --front-end fxc");
  study::SheetOptions sheet;
  if (!options.sheet.file.empty()) {
    sheet = sheet_options(options.sheet, settings, subjects);
    settings.window = sheet.window;
    for (const study::SheetChoice& choice : sheet.pictures) {
      if (choice.kind == study::SheetPicture::debug_view) settings.debug_views.push_back(choice.view);
    }
  }
  std::optional<study::LitView> lit;
  if (options.lit.wanted) lit.emplace(light_study(options.lit, settings), study_progress(context));
  if (lit) settings.answered = [&lit](const study::SubjectAnswer& answer) { lit->add(answer); };
  gpu::Device device = open_device(options);
  study::StudyOutcome outcome = study::run_study(device, subjects, settings, study_progress(context));
  tell_notes(outcome.notes, context);
  tell_invalid_results(outcome.records, context);
  if (lit) lit->replace_pictures(outcome.pictures);

  if (options.sheet.file.empty()) {
    write_rows(options.output.empty() ? "." : options.output, outcome);
  } else {
    study::Picture picture = study::contact_sheet(outcome.records, outcome.pictures, sheet);
    if (options.sheet.max_width > 0) picture = study::narrowed(picture, options.sheet.max_width);
    write_picture(options.sheet.file, picture);
    write_output("", options.sheet.file + "\n");
  }
  outcome.kept->drop();
}

}  // namespace

void add_render(CLI::App& app, Context& context) {
  CLI::App* command =
      app.add_subcommand("render", "Render shadow techniques next to the ray-traced reference");
  auto options = std::make_shared<RenderOptions>();
  options->lights = {2.0};
  add_study_options(*command, *options, "contact-boxes");
  add_technique_list_option(*command, options->technique_list)->group("What to render");
  add_technique_option(*command, options->techniques, "pcss-angular-24-16")->group("What to render");
  add_adapters(*command, options->adapters)->group("What to render");
  add_set_option(*command, "What to render", options->varied);
  as_list(
      command->add_option("--frames", options->varied.frames,
                          "Number of frames to average, each with different noise; one picture per number"))
      ->type_name("N")
      ->check(within(1, 64))
      ->default_str("1")
      ->group("What to render");
  add_title_option(*command, "What to render", options->varied);
  command->add_option("--adapters", options->varied.adapters, "Position of the adapters among the techniques")
      ->type_name("PLACE")
      ->check(one_of({"first", "last"}))
      ->group("What to render");
  CLI::Option* folder = command->add_option("-o,--output", options->output, "Folder for the pictures")
                            ->type_name("FOLDER")
                            ->default_str(".");
  add_sheet_options(*command, options->sheet)->excludes(folder);
  add_lit_options(*command, options->lit);
  end_help(
      *command, "",
      {{"penumbra render --technique preset-medium,preset-high --light 0.53,5 --sheet presets.png",
        "one picture with captions: two presets under two lights, next to the reference"},
       {"penumbra render --lit --scene garden --technique preset-high --size 1280x720 --sheet garden.png",
        "lit scene with materials, sun and sky"},
       {"penumbra render --technique pcss-angular-24-16 --set blockerSamples=4,16,64 --crop 300,180,120,80 "
        "--zoom 3 --sheet blockers.png",
        "what a parameter does, enlarged"},
       {"penumbra render --scene model.glb --technique preset-high -o pictures", "each picture as a file"}});
  command->callback([command, options, &context] { render(*command, *options, context); });
}

}  // namespace penumbra::cli
