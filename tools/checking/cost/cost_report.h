// The costs of shaders, row by row: one row per GPU family and distinct module.
//
// The JSON is {"command", "driver", "compiler", "families": [{name, device, driver}], "rows": [{family, file,
// entry, stage, variants: [{technique, keywords}], subgroup_size, figures: {...}, statistics: {driver's name:
// value}} or, without figures, {..., failure}]}. The same shaders, families and driver give the same bytes:
// it contains no time, path of a machine or hash.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cost/null_radv.h"

namespace penumbra::cost {

// A variant that compiles to a module.
struct CostVariant {
  std::string technique;  // empty for a user's file
  std::vector<std::string> keywords;

  bool operator==(const CostVariant&) const = default;
};

struct CostRow {
  std::string family;
  std::string file;
  std::string entry;
  std::string stage;
  std::vector<CostVariant> variants;  // all variants that compile to this one module
  Measurement measured;
};

struct CostReport {
  std::string command;   // the command that reproduces the report
  std::string driver;    // the GPU compiler, with its version; FXC where there is no other family
  std::string compiler;  // shaders::compiler_version(), which made the SPIR-V; FXC where there is none
  std::vector<RadvFamily> families;
  std::vector<CostRow> rows;

  std::size_t failures() const;
};

// Returns the compiler of a family's rows; without an entry for it, the report's driver.
const std::string& driver_of(const CostReport& report, const std::string& family);

// Returns "tent-5 +UNITY_REVERSED_Z", "box-3 (and 3 more)", "My.hlsl Main +A".
std::string row_name(const CostRow& row);

std::string cost_json(const CostReport& report);
// The CSV has one line a row, figures only. A text that a spreadsheet would take for a formula (=, +, - or @
// first) begins with an apostrophe; sets of keywords ("+A +B") stay as they are.
std::string cost_csv(const CostReport& report);
// Returns the text for a terminal: a table for each family, then the failures.
std::string cost_table(const CostReport& report);

// Reads a file that cost_json() wrote; throws InputError with file:line:column.
CostReport read_cost_report(const std::filesystem::path& file);

}  // namespace penumbra::cost
