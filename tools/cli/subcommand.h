// What every subcommand file offers main.cpp: a function that adds it to the program's command line.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra::cli {

// What the program ends with; failure.h says which exception becomes which.
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
  std::vector<std::string> arguments;  // as typed, without the program's name
  int exit_code = success;             // a subcommand that found something sets findings
};

// Writes to standard output when `file` is empty or "-", else atomically to the file.
void write_output(const std::string& file, std::string_view content);

// A progress line on stderr: only on a terminal, never with --quiet. One per running job.
class Progress {
 public:
  Progress(const Context& context, std::string label);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  // Shows label, bar, done/total, rate per second (with SI prefix and `unit`) and time left.
  void update(double done, double total, std::string_view unit = "");

 private:
  struct State;
  State* state_;
};

void add_constants(CLI::App& app, Context& context);
void add_tables(CLI::App& app, Context& context);
void add_validate(CLI::App& app, Context& context);
void add_cost(CLI::App& app, Context& context);
void add_merge(CLI::App& app, Context& context);
void add_render(CLI::App& app, Context& context);
void add_measure(CLI::App& app, Context& context);

}  // namespace penumbra::cli
