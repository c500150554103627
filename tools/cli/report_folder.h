// The folder of `penumbra measure --output`: results.json and results.tsv, report.html, charts and pictures.
#pragma once

#include <filesystem>
#include <vector>

#include "study/report.h"

namespace penumbra::cli {

// Where a file of the report belongs there may be an older one, and nothing else: throws InputError.
void check_report_files(const std::filesystem::path& folder);

// Writes the results before what is drawn of them: if drawing fails, they are there, and no other report is
// beside them.
void write_report(const std::filesystem::path& folder, const study::Results& results,
                  std::vector<study::PictureRow> pictures, study::FactsOfTechniques facts);

// Prints the figures that come first in the report, and where it is.
void print_headlines(const std::filesystem::path& folder, const study::Results& results);

}  // namespace penumbra::cli
