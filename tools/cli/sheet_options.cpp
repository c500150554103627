#include "cli/sheet_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>

#include "cli/option_values.h"
#include "cli/study_options.h"
#include "cli/subcommand.h"
#include "input/input_error.h"
#include "study/insets.h"

namespace penumbra::cli {
namespace {

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

}  // namespace

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
                       "fallback-high and the techniques named ...-masked have one");
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

}  // namespace penumbra::cli
