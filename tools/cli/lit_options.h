// The options of `render` for the lit view.
#pragma once

#include <CLI/CLI.hpp>

#include "lighting/lit_frame.h"
#include "study/study.h"

namespace penumbra::cli {

struct LitArguments {
  bool wanted = false;
  int supersampling = 2;
  double exposure_stops = 0.0;
};

void add_lit_options(CLI::App& command, LitArguments& arguments);

// Returns the lighting of the study's frames. The study's frame and window are enlarged by the supersampling.
// Throws InputError for a picture that would grow beyond 8192 pixels a side.
lighting::LitSettings light_study(const LitArguments& arguments, study::StudySettings& settings);

}  // namespace penumbra::cli
