// Reports read back, and the reports of all shards of one run joined into the report of that run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "validation/report.h"

namespace penumbra::validation {

// What report_json() wrote. Throws InputError at file:line:column for anything else, and where the summary
// does not agree with the records.
ValidationReport read_report_json(const std::filesystem::path& file);

struct NamedReport {
  std::string name;  // for messages: the file it was read from
  ValidationReport report;
};

// Records stand in the order of the request, as the run without shards has them; counts are counted again,
// seconds are added up, "unique" counts a module that several shards met once where records name it. Throws
// InputError unless each shard of one request is there just once and no two hold the same record. One report
// that is the whole run is its own merger.
ValidationReport merge_reports(std::vector<NamedReport> reports);

}  // namespace penumbra::validation
