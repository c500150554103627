// The options of `render` that make a contact sheet.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "study/contact_sheet.h"
#include "study/study.h"

namespace penumbra::cli {

struct SheetArguments {
  std::string file;                   // empty means no sheet
  std::string crop;                   // X,Y,WIDTH,HEIGHT; empty means all of the picture
  std::vector<std::string> insets{};  // X,Y,WIDTH,HEIGHT each
  std::string reference = "first";    // "first" or "last"
  int zoom = 1;
  int columns = 0;
  std::vector<std::string> show{"result"};
};

CLI::Option* add_sheet_options(CLI::App& command, SheetArguments& arguments);  // returns --sheet

// Throws InputError for a crop or an inset that is invalid or extends beyond the picture, for a mask if no
// subject has one, for a sheet with more pixels than a PNG should have, and for a file in a missing folder or
// of another type than PNG and JPEG.
study::SheetOptions sheet_options(const SheetArguments& arguments, const study::StudySettings& settings,
                                  const std::vector<study::Subject>& subjects);

}  // namespace penumbra::cli
