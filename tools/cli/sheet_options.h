// The options of `render` that make a contact sheet.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "study/contact_sheet.h"
#include "study/study.h"

namespace penumbra::cli {

struct SheetArguments {
  std::string file;  // empty: no sheet
  std::string crop;  // X,Y,WIDTH,HEIGHT; empty: all of the picture
  int zoom = 1;
  int columns = 0;
  std::vector<std::string> show{"result"};
};

CLI::Option* add_sheet_options(CLI::App& command, SheetArguments& arguments);  // returns --sheet

// Throws InputError for a crop that is none or reaches beyond the picture, for a mask where no subject has
// one, for a sheet of more pixels than a PNG should have, and for a file in no folder.
study::SheetOptions sheet_options(const SheetArguments& arguments, const study::StudySettings& settings,
                                  const std::vector<study::Subject>& subjects);

}  // namespace penumbra::cli
