// penumbra emit writes the files that are made from techniques' manifests, each at its place, or one
// technique as one HLSL file.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>

#include "cli/help.h"
#include "cli/known_names.h"
#include "cli/option_text.h"
#include "cli/shared_options.h"
#include "cli/subcommand.h"
#include "input/input_error.h"
#include "input/text_file.h"
#include "input/visible_text.h"
#include "platform/atomic_file.h"
#include "techniques/generated_files.h"
#include "techniques/single_file.h"

namespace penumbra::cli {
namespace {

namespace fs = std::filesystem;

struct EmitOptions {
  std::string techniques;
  bool check = false;
  std::string single_file;  // a technique's name
  std::string output;
};

// A source file of somebody's own is not replaced; one that this program wrote says so.
void refuse_foreign_source(const fs::path& file, std::string_view text) {
  constexpr std::string_view kMark = "Written by `penumbra";
  std::error_code ignored;
  if (text.find(kMark) == std::string_view::npos || !fs::is_regular_file(file, ignored)) return;
  if (fs::file_size(file, ignored) > 0 && read_text_file(file).find(kMark) == std::string::npos)
    throw InputError(file.string(), "exists and was not written by penumbra",
                     "move it, or delete it if what is written now is meant to replace it");
}

// A package may be a stranger's, whose links would lead the output elsewhere. The package's own folder may be
// a link: the user names it.
void refuse_link(const fs::path& package, const fs::path& file) {
  if (const std::optional<fs::path> link = platform::link_below(package, package / file))
    throw InputError(link->string(), "is a symbolic link, which output does not follow",
                     "put the folder or file itself there");
}

struct ChangedFile {
  fs::path file;
  std::string text;
  std::string difference;  // is the first differing line
};

// The text says what is there, and what would be.
std::string first_difference(const std::string& found, const std::string& text) {
  const std::vector<std::string> before = split(found, '\n'), after = split(text, '\n');
  const auto [is, would] = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
  const auto said = [](auto line, const std::vector<std::string>& lines, const std::string& whole) {
    if (line != lines.end()) return "'" + visible_line(*line) + "'";
    return std::string("the end of the file") + (whole.ends_with('\n') ? "" : " without a line break");
  };
  return fmt::format("{}: {} would be {}", is - before.begin() + 1, said(is, before, found),
                     said(would, after, text));
}

std::vector<ChangedFile> changed_files(const techniques::TechniqueList& list) {
  const std::vector<techniques::EmittedFile> files = techniques::generated_files(list);
  for (const techniques::EmittedFile& emitted : files) refuse_link(list.package, emitted.file);
  std::vector<ChangedFile> changed;
  for (const techniques::EmittedFile& emitted : files) {
    const fs::path file = (list.package / emitted.file).lexically_normal();
    std::error_code ignored;
    const bool exists = fs::exists(file, ignored);
    const std::string found = exists ? read_found_text_file(file) : "";
    if (exists && found == emitted.text) continue;
    changed.push_back(
        {file, emitted.text, exists ? first_difference(found, emitted.text) : "1: there is no such file"});
  }
  return changed;
}

// All folders are made, and all files looked at, before the first file is written.
void write(const std::vector<ChangedFile>& changed) {
  std::vector<platform::FileContent> contents;
  std::string names;
  for (const ChangedFile& each : changed) {
    refuse_foreign_source(each.file, each.text);
    std::error_code error;
    if (each.file.has_parent_path()) fs::create_directories(each.file.parent_path(), error);
    if (error)
      throw InputError(each.file.parent_path().string(), "the folder cannot be made: " + error.message());
    contents.push_back({each.file, each.text});
    names += each.file.string() + "\n";
  }
  platform::write_files_atomically(contents);
  write_output("", names);
}

void emit_all(const EmitOptions& options, Context& context) {
  const std::vector<ChangedFile> changed =
      changed_files(techniques::read_technique_list(options.techniques.empty() ? "." : options.techniques));
  if (!options.check) {
    write(changed);
    if (changed.empty() && !context.quiet) std::fprintf(stderr, "every file is up to date\n");
    return;
  }
  std::string text;
  for (const ChangedFile& each : changed) text += each.file.string() + ":" + each.difference + "\n";
  if (!changed.empty()) context.exit_code = findings;
  write_output("", text);
}

void emit_single_file(const EmitOptions& options) {
  check_output_file(options.output);
  const techniques::TechniqueList list = chosen_technique_list(options.techniques);
  const techniques::SingleFile single =
      techniques::single_file(list, list.find(options.single_file), PENUMBRA_VERSION);
  std::vector<std::string> inputs{options.techniques};
  for (const fs::path& file : single.pasted) inputs.push_back(file.string());
  refuse_input_as_output("--output", options.output, inputs);
  refuse_foreign_source(options.output, single.text);
  write_output(options.output, single.text);
}

}  // namespace

void add_emit(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand("emit",
                                         "Write the C#, HLSL and JSON that are made from techniques' "
                                         "manifests, or one technique as one HLSL file");
  auto options = std::make_shared<EmitOptions>();
  add_technique_list_option(*command, options->techniques)
      ->default_str("the package in the current folder; with --single-file the library's");
  CLI::Option* check = command->add_flag("--check", options->check,
                                         "Write nothing; name each file that would change, with its first "
                                         "line that differs, and exit with 1 if there is one");
  CLI::Option* single = command->add_option("--single-file", options->single_file,
                                            "Write this technique's filter instead, with everything that it "
                                            "includes, as one file without includes");
  takes(*command, single, "TECHNIQUE");
  single->default_str("none")->excludes(check);
  add_output_file(*command, options->output)->needs(single);
  end_help(
      *command,
      "Files that are as they should be are left alone; the names of the others are printed. Either all of "
      "them are\nwritten or none. The files of a single manifest are written into its folder: the HLSL "
      "beside it, the C# below\nRuntime/. A source file that penumbra did not write is not replaced.",
      {{"penumbra emit", "in the folder of a package, after a change of a manifest"},
       {"penumbra emit --check", "in CI"},
       {"penumbra emit --technique-list Ring.technique.json", "of a technique of your own"},
       {"penumbra emit --single-file pcss-angular-24-16 -o Pcss.hlsl", "for an engine of your own"}});
  command->callback([options, &context] {
    if (options->single_file.empty())
      emit_all(*options, context);
    else
      emit_single_file(*options);
  });
}

}  // namespace penumbra::cli
