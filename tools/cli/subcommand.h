// The interface of a subcommand file: a function that adds it to the program's command line.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/progress.h"

namespace CLI {
class App;
}

namespace penumbra::cli {

// The program's exit codes; failure_of() maps exceptions to them.
enum ExitCode {
  success = 0,
  findings = 1,
  bad_input = 2,
  bad_environment = 3,
  internal_error = 70,
  interrupted = 130
};

struct Context {
  bool quiet = false;
  std::vector<std::string> arguments;  // the arguments as typed, without the program's name
  int exit_code = success;             // a subcommand with findings sets `findings`
  std::shared_ptr<ProgressOutlet> outlet = std::make_shared<ProgressOutlet>();

  std::shared_ptr<ProgressOutlet> progress() const { return quiet ? nullptr : outlet; }
};

// Writes to standard output when `file` is empty or "-", else atomically to the file.
void write_output(const std::string& file, std::string_view content);

// Throw InputError if writing could not succeed: a folder in the file's place, a folder that does not exist
// or is not writable. They are called before work begins, and leave nothing behind.
void check_output_file(const std::string& file);      // "" and "-", standard output, pass
void check_output_folder(const std::string& folder);  // the folder need not exist yet; "" passes

// Throws InputError if `output`, the value of `option`, is one of the files that the run reads, under
// whatever name. Empty names are skipped.
void refuse_input_as_output(const std::string& option, const std::string& output,
                            const std::vector<std::string>& inputs);

// Throws the same for a report in the place of a shader or a manifest, whether or not the run reads it.
void refuse_report_over_source(const std::string& option, const std::string& output);

// A cache that cannot be written to causes a note only. The folder is `given` by --cache, or else `standard`.
// Throws InputError where a file is in the place of the folder that was given.
void check_cache_folder(const std::string& given, const std::filesystem::path& standard,
                        const Context& context);

void add_constants(CLI::App& app, Context& context);
void add_tables(CLI::App& app, Context& context);
void add_validate(CLI::App& app, Context& context);
void add_emit(CLI::App& app, Context& context);
void add_cost(CLI::App& app, Context& context);
void add_merge(CLI::App& app, Context& context);
void add_render(CLI::App& app, Context& context);
void add_measure(CLI::App& app, Context& context);
void add_bake(CLI::App& app, Context& context);

}  // namespace penumbra::cli
