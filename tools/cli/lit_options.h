// The options of `render` that turn numbers into photographs.
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

// How to light what the study draws. The study's own frame and window grow by the supersampling. Throws
// InputError for a picture that would grow beyond 8192 pixels a side.
lighting::LitSettings light_study(const LitArguments& arguments, study::StudySettings& settings);

}  // namespace penumbra::cli
