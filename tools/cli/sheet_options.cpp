#include "cli/sheet_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>

#include "input/input_error.h"

namespace penumbra::cli {
namespace {

constexpr std::int64_t kMostPixels = std::int64_t{1} << 26;

study::PictureWindow window_of(const std::string& crop, int width, int height) {
  study::PictureWindow window;
  char extra = 0;
  const int read =
      std::sscanf(crop.c_str(), "%d,%d,%d,%d%c", &window.x, &window.y, &window.width, &window.height, &extra);
  if (read != 4 || window.width < 1 || window.height < 1) {
    throw InputError("",
                     "--crop '" + crop + "' is not X,Y,WIDTH,HEIGHT in pixels from the left upper corner");
  }
  if (window.x < 0 || window.y < 0 || window.x > width - window.width || window.y > height - window.height) {
    throw InputError("",
                     fmt::format("--crop {} reaches beyond the picture of {}x{} pixels", crop, width, height),
                     "--size gives another picture");
  }
  return window;
}

// What --show may name; a debug view by its pass of PenumbraDebugViews.shader.
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
  return subject.screen.has_value();
}

bool has_mask(const study::Subject& subject) {
  return subject.screen && subject.screen->mask >= 0;
}

void refuse_without_a_place(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder)) {
    throw InputError(file.string(), "there is no folder '" + folder.string() + "'");
  }
  if (std::filesystem::is_directory(file)) {
    throw InputError(file.string(), "is a folder", "--sheet names the PNG file");
  }
}

// Captions left out: they are small beside pictures of this number.
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
  CLI::Option* sheet =
      command
          .add_option("--sheet", arguments.file, "Write one PNG: the reference and all pictures, captioned")
          ->group("Sheet");
  command.add_option("--crop", arguments.crop, "X,Y,WIDTH,HEIGHT: show, and measure, this part alone")
      ->needs(sheet)
      ->group("Sheet");
  command.add_option("--zoom", arguments.zoom, "Pixels of the sheet per pixel, each way")
      ->check(CLI::Range(1, 16))
      ->needs(sheet)
      ->group("Sheet");
  command.add_option("--columns", arguments.columns, "Pictures side by side; default: up to four")
      ->check(CLI::Range(1, 64))
      ->needs(sheet)
      ->group("Sheet");
  command
      .add_option(
          "--show", arguments.show,
          "Of each technique: result, error, fetches, mask; of those over the screen also the debug views "
          "visibility, cascades, shadow-texels, penumbra-width, penumbra-mask")
      ->delimiter(',')
      ->check(CLI::IsMember(shown_names()))
      ->needs(sheet)
      ->group("Sheet");
  return sheet;
}

study::SheetOptions sheet_options(const SheetArguments& arguments, const study::StudySettings& settings,
                                  const std::vector<study::Subject>& subjects) {
  refuse_without_a_place(arguments.file);
  study::SheetOptions options;
  options.zoom = arguments.zoom;
  options.columns = arguments.columns;
  if (!arguments.crop.empty()) {
    options.window = window_of(arguments.crop, settings.frame.width, settings.frame.height);
  }
  options.pictures.clear();
  for (const std::string& name : arguments.show) {
    const study::SheetChoice& choice = shown_pictures().at(name);
    if (std::find(options.pictures.begin(), options.pictures.end(), choice) == options.pictures.end()) {
      options.pictures.push_back(choice);
    }
    if (choice.kind == study::SheetPicture::mask &&
        std::none_of(subjects.begin(), subjects.end(), has_mask)) {
      throw InputError("", "--show mask: no technique of this sheet has a mask",
                       "preset-high has one, and so has what is called ...-masked");
    }
    if (choice.kind == study::SheetPicture::debug_view &&
        std::none_of(subjects.begin(), subjects.end(), runs_over_the_screen)) {
      throw InputError("", "--show " + name + ": no technique of this sheet runs over the screen",
                       "the presets do, and what is called screen-...");
    }
  }
  refuse_too_large(options, settings, subjects.size());
  return options;
}

}  // namespace penumbra::cli
