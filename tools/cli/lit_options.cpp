#include "cli/lit_options.h"

#include <fmt/format.h>

#include "cli/option_values.h"
#include "input/input_error.h"

namespace penumbra::cli {

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

}  // namespace penumbra::cli
