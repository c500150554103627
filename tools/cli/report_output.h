// Output of the subcommands that produce a validation report.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cli/subcommand.h"
#include "validation/report.h"

namespace penumbra::cli {

struct ReportOptions {
  std::string form = "text";
  std::string output;
  std::string root;
  bool verbose = false;
};

// Adds --format, --output, --root and --verbose.
void add_report_options(CLI::App& command, ReportOptions& options);

// Sets the exit code to findings if a variant failed.
void write_report(const ReportOptions& options, const validation::ValidationReport& report, Context& context);

}  // namespace penumbra::cli
