// Reads JSON reports, and merges those of all shards of a run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "validation/report.h"

namespace penumbra::validation {

// Reads the output of report_json(). Throws InputError at file:line:column for anything else, and if the
// summary does not agree with the records.
ValidationReport read_report_json(const std::filesystem::path& file);

struct NamedReport {
  std::string name;  // the file that it was read from, for messages
  ValidationReport report;
};

// Records are in the order of the request, as in the run without shards. Counts are recomputed and seconds
// are added up; "unique" counts a module once that occurs in several shards if records name it. Throws
// InputError unless each shard of one request is given exactly once and no two contain the same record. A
// report of a whole run is returned unchanged.
ValidationReport merge_reports(std::vector<NamedReport> reports);

}  // namespace penumbra::validation
