// penumbra render: one frame as pictures, techniques beside the reference.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/help.h"
#include "cli/option_values.h"
#include "cli/shared_options.h"
#include "cli/study_messages.h"
#include "cli/study_options.h"
#include "cli/subcommand.h"
#include "cli/varied_subjects.h"
#include "input/input_error.h"
#include "lighting/lit_frame.h"
#include "platform/cache_store.h"
#include "reference/trace_visibility.h"
#include "study/contact_sheet.h"
#include "study/kept_records.h"
#include "study/lit_view.h"
#include "study/study.h"

namespace penumbra::cli {
namespace {

// The options of `render` that make a contact sheet.
struct SheetArguments {
  std::string file;                   // empty means no sheet
  std::string crop;                   // X,Y,WIDTH,HEIGHT; empty means all of the picture
  std::vector<std::string> insets{};  // X,Y,WIDTH,HEIGHT each
  std::string reference = "first";    // "first" or "last"
  int zoom = 1;
  int columns = 0;
  int max_width = 0;  // 0: any
  std::vector<std::string> show{"result"};
};

constexpr std::int64_t kMostPixels = std::int64_t{1} << 26;

bool lies_inside(const study::PictureWindow& inner, const study::PictureWindow& outer) {
  return inner.x >= outer.x && inner.y >= outer.y && inner.width <= outer.width &&
         inner.height <= outer.height && inner.x - outer.x <= outer.width - inner.width &&
         inner.y - outer.y <= outer.height - inner.height;
}

study::PictureWindow window_of(const std::string& option, const std::string& text) {
  study::PictureWindow window;
  char extra = 0;
  const int read =
      std::sscanf(text.c_str(), "%d,%d,%d,%d%c", &window.x, &window.y, &window.width, &window.height, &extra);
  if (read != 4 || window.width < 1 || window.height < 1) {
    throw InputError("",
                     option + " '" + text + "' is not X,Y,WIDTH,HEIGHT in pixels from the upper left corner");
  }
  return window;
}

study::PictureWindow crop_of(const std::string& text, const study::PictureWindow& picture) {
  const study::PictureWindow window = window_of("--crop", text);
  if (!lies_inside(window, picture)) {
    throw InputError("",
                     fmt::format("--crop {} extends beyond the picture of {}x{} pixels", text, picture.width,
                                 picture.height),
                     "--size sets the size of the picture");
  }
  return window;
}

std::vector<study::PictureWindow> insets_of(const std::vector<std::string>& texts,
                                            const study::PictureWindow& shown, int zoom) {
  std::vector<study::PictureWindow> insets;
  for (const std::string& text : texts) {
    insets.push_back(window_of("--inset", text));
    if (lies_inside(insets.back(), shown)) continue;
    throw InputError("", fmt::format("--inset {} extends beyond what is shown, {}x{} pixels from {},{}", text,
                                     shown.width, shown.height, shown.x, shown.y));
  }
  if (!insets.empty() && study::inset_factor(shown.width * zoom, insets) == 0) {
    throw InputError("", "the insets are too wide to fit side by side beneath a picture",
                     "show fewer or smaller ones");
  }
  return insets;
}

// The names that --show takes; a debug view goes by its pass of PenumbraDebugViews.shader.
const std::map<std::string, study::SheetChoice>& shown_pictures() {
  using study::SheetPicture;
  static const std::map<std::string, study::SheetChoice> pictures{
      {"result", SheetPicture::result},
      {"error", SheetPicture::error},
      {"fetches", SheetPicture::fetches},
      {"mask", SheetPicture::mask},
      {"cascades", {SheetPicture::debug_view, "Cascades"}},
      {"shadow-texels", {SheetPicture::debug_view, "ShadowTexels"}},
      {"penumbra-width", {SheetPicture::debug_view, "PenumbraWidth"}},
      {"penumbra-mask", {SheetPicture::debug_view, "PenumbraMask"}},
      {"visibility", {SheetPicture::debug_view, "Visibility"}},
  };
  return pictures;
}

std::vector<std::string> shown_names() {
  std::vector<std::string> names;
  for (const auto& [name, choice] : shown_pictures()) names.push_back(name);
  return names;
}

bool runs_over_the_screen(const study::Subject& subject) {
  return subject.graph.graph.over_screen();
}

bool has_mask(const study::Subject& subject) {
  return !subject.graph.graph.mask.empty();
}

void refuse_without_a_place(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder)) {
    throw InputError(file.string(), "the folder '" + folder.string() + "' does not exist");
  }
  if (std::filesystem::is_directory(file)) {
    throw InputError(file.string(), "is a folder", "--sheet names the PNG or JPEG file");
  }
  if (!is_jpeg_name(file) && file.extension() != ".png" && file.extension() != ".PNG") {
    throw InputError(file.string(), "ends in neither .png nor .jpg", "a sheet is written as PNG or as JPEG");
  }
}

// The estimate leaves out captions, which are small beside so many pictures.
void refuse_too_large(const study::SheetOptions& options, const study::StudySettings& settings,
                      std::size_t subjects) {
  const study::PictureWindow shown =
      options.window.value_or(study::PictureWindow{0, 0, settings.frame.width, settings.frame.height});
  const double cells = static_cast<double>(settings.scenes.size() * settings.light_degrees.size()) *
                       static_cast<double>(1 + subjects * options.pictures.size());
  const double pixels = cells * shown.width * shown.height * options.zoom * options.zoom;
  if (pixels > static_cast<double>(kMostPixels)) {
    throw InputError("", fmt::format("the sheet would have {:.0f} million pixels", pixels / 1e6),
                     "crop more, zoom less or show less");
  }
}

// returns --sheet
CLI::Option* add_sheet_options(CLI::App& command, SheetArguments& arguments) {
  CLI::Option* sheet = command
                           .add_option("--sheet", arguments.file,
                                       "Write one PNG or JPEG with the reference and all pictures, captioned")
                           ->type_name("FILE")
                           ->default_str("none")
                           ->group("Sheet");
  command
      .add_option("--crop", arguments.crop,
                  "Show and measure only this part, in pixels from the upper left corner")
      ->type_name("X,Y,WIDTH,HEIGHT")
      ->default_str("all of the picture")
      ->needs(sheet)
      ->group("Sheet");
  command.add_option("--zoom", arguments.zoom, "Enlargement: pixels of the sheet per pixel, in x and y")
      ->type_name("N")
      ->check(within(1, 16))
      ->needs(sheet)
      ->group("Sheet");
  one_each(
      command.add_option("--inset", arguments.insets, "Part of every picture to show enlarged beneath it"))
      ->type_name("X,Y,WIDTH,HEIGHT")
      ->default_str("none")
      ->needs(sheet)
      ->group("Sheet");
  command.add_option("--reference", arguments.reference, "Position of the ray-traced picture")
      ->type_name("PLACE")
      ->check(one_of({"first", "last"}))
      ->needs(sheet)
      ->group("Sheet");
  command.add_option("--columns", arguments.columns, "Pictures per row")
      ->type_name("N")
      ->check(within(1, 64))
      ->default_str("up to four")
      ->needs(sheet)
      ->group("Sheet");
  command.add_option("--max-width", arguments.max_width, "Scale a wider sheet down to this width, in pixels")
      ->type_name("N")
      ->check(within(64, 16384))
      ->default_str("any")
      ->needs(sheet)
      ->group("Sheet");
  command
      .add_option("--show", arguments.show,
                  "What to show of each technique; cascades, shadow-texels, penumbra-width, penumbra-mask "
                  "and visibility exist for the presets and the screen-... techniques only")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("PICTURE")
      ->check(one_of(shown_names()))
      ->needs(sheet)
      ->group("Sheet");
  return sheet;
}

// Throws InputError for a crop or an inset that is invalid or extends beyond the picture, for a mask if no
// subject has one, for a sheet with more pixels than a PNG should have, and for a file in a missing folder or
// of another type than PNG and JPEG.
study::SheetOptions sheet_options(const SheetArguments& arguments, const study::StudySettings& settings,
                                  const std::vector<study::Subject>& subjects) {
  refuse_without_a_place(arguments.file);
  check_output_file(arguments.file);
  study::SheetOptions options;
  options.zoom = arguments.zoom;
  options.columns = arguments.columns;
  const study::PictureWindow picture{0, 0, settings.frame.width, settings.frame.height};
  if (!arguments.crop.empty()) options.window = crop_of(arguments.crop, picture);
  options.insets = insets_of(arguments.insets, options.window.value_or(picture), arguments.zoom);
  options.reference_last = arguments.reference == "last";
  options.pictures.clear();
  for (const std::string& name : arguments.show) {
    const study::SheetChoice& choice = shown_pictures().at(name);
    if (std::find(options.pictures.begin(), options.pictures.end(), choice) == options.pictures.end()) {
      options.pictures.push_back(choice);
    }
    if (choice.kind == study::SheetPicture::mask &&
        std::none_of(subjects.begin(), subjects.end(), has_mask)) {
      throw InputError("", "--show mask: no technique of this sheet has a mask",
                       "the techniques named ...-masked have one");
    }
    if (choice.kind == study::SheetPicture::debug_view &&
        std::none_of(subjects.begin(), subjects.end(), runs_over_the_screen)) {
      throw InputError("", "--show " + name + ": no technique of this sheet runs as a screen pass",
                       "the presets and the techniques named screen-... do");
    }
  }
  refuse_too_large(options, settings, subjects.size());
  return options;
}

// The options of `render` for the lit view.
struct LitArguments {
  bool wanted = false;
  int supersampling = 2;
  double exposure_stops = 0.0;
};

void add_lit_options(CLI::App& command, LitArguments& arguments) {
  CLI::Option* lit =
      command
          .add_flag("--lit", arguments.wanted,
                    "Draw the lit scene, with materials, sun and sky, instead of visibility only")
          ->group("Lit view");
  command
      .add_option("--supersampling", arguments.supersampling,
                  "Supersampling in x and y; techniques run at this multiple of the size")
      ->type_name("N")
      ->check(within(1, 4))
      ->needs(lit)
      ->group("Lit view");
  command.add_option("--exposure", arguments.exposure_stops, "Exposure correction, in stops")
      ->type_name("STOPS")
      ->check(within(-10, 10))
      ->needs(lit)
      ->group("Lit view");
}

// Returns the lighting of the study's frames. The study's frame and window are enlarged by the supersampling.
// Throws InputError for a picture that would grow beyond 8192 pixels a side.
lighting::LitSettings light_study(const LitArguments& arguments, study::StudySettings& settings) {
  constexpr int kMostPixels = 8192;
  const int factor = arguments.supersampling;
  scene::FrameSettings& frame = settings.frame;
  if (frame.width * factor > kMostPixels || frame.height * factor > kMostPixels) {
    throw InputError(
        "",
        fmt::format("a picture of {}x{} with supersampling {} needs frames larger than {} pixels per side",
                    frame.width, frame.height, factor, kMostPixels),
        "use a smaller --size or --supersampling 1");
  }
  frame.width *= factor;
  frame.height *= factor;
  if (settings.window) {
    study::PictureWindow& window = *settings.window;
    window = {window.x * factor, window.y * factor, window.width * factor, window.height * factor};
  }
  lighting::LitSettings lit;
  lit.supersampling = factor;
  lit.exposure_stops = arguments.exposure_stops;
  lit.sun_rays = settings.reference_samples;
  lit.seed = settings.seed;
  lit.jobs = settings.jobs;
  lit.cache = settings.cache;
  return lit;
}

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
    write_picture(folder / (name + ".png"), study::record_sheet(outcome.records[i], row));
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
  const std::vector<study::Subject> subjects = varied_subjects(options, options.varied);
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
