// The folder of `penumbra measure --output`: results.json and results.tsv, report.html, charts and pictures.
#pragma once

#include <filesystem>
#include <vector>

#include "study/report.h"

namespace penumbra::cli {

// Throws InputError if something other than an older file stands where a file of the report belongs.
void check_report_files(const std::filesystem::path& folder);

// Writes the results before the charts and pages: if drawing fails, the results are there, and no other
// report is beside them.
void write_report(const std::filesystem::path& folder, const study::Results& results,
                  std::vector<study::PictureRow> pictures, study::FactsOfTechniques facts);

// Prints the figures that come first in the report, and where it is.
void print_headlines(const std::filesystem::path& folder, const study::Results& results);

}  // namespace penumbra::cli
