#include "cli/emitted_files.h"

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <system_error>
#include <vector>

#include "cli/subcommand.h"
#include "input/input_error.h"
#include "input/text_file.h"
#include "platform/linked_folder.h"
#include "shaders/package_shader.h"
#include "techniques/graph_emit.h"
#include "techniques/look_emit.h"
#include "techniques/option_emit.h"
#include "techniques/packing_cases.h"
#include "techniques/parameter_emit.h"
#include "techniques/preset_emit.h"
#include "techniques/preset_programs.h"
#include "techniques/selection_emit.h"
#include "techniques/selection_hlsl.h"
#include "techniques/technique_json.h"

namespace penumbra::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kGroup = "Write a file (- is standard output) instead of validating";

struct EmittedFile {
  const char* option;
  std::string EmittedFiles::*file;
  const char* description;
  std::function<std::string(const techniques::TechniqueList&)> text;
};

std::string programs(const techniques::TechniqueList& list) {
  return techniques::preset_programs_json(list, shaders::PackageShader(shaders::package_shader_file()));
}

const std::array<EmittedFile, 8>& emitted_files() {
  static const std::array<EmittedFile, 8> files{
      {{"--emit-presets", &EmittedFiles::presets, "The quality presets as C#",
        techniques::emit_presets_csharp},
       {"--emit-looks", &EmittedFiles::looks, "The looks as C#", techniques::emit_looks_csharp},
       {"--emit-keywords", &EmittedFiles::keywords,
        "The include file that selects a technique by shader keyword, as HLSL",
        techniques::emit_keywords_hlsl},
       {"--emit-selections", &EmittedFiles::selections, "The techniques of the renderer feature as C#",
        techniques::emit_selections_csharp},
       {"--emit-options", &EmittedFiles::options, "Labels, tooltips and ranges of its options as C#",
        techniques::emit_options_csharp},
       {"--emit-techniques", &EmittedFiles::techniques,
        "The techniques with all defaults, passes and textures, as JSON", techniques::techniques_json},
       {"--emit-packing", &EmittedFiles::packing,
        "Values of every parameter struct and the vectors they are packed into, as JSON",
        techniques::packing_cases_json},
       {"--emit-programs", &EmittedFiles::programs,
        "Programs of the renderer feature's shader that each quality preset keeps in a player build, as JSON",
        programs}}};
  return files;
}

// An option that writes several files into a folder of a package.
struct EmittedFolder {
  const char* option;
  std::string EmittedFiles::*folder;
  const char* description;
  std::function<std::vector<techniques::EmittedFile>(const techniques::TechniqueList&)> files;
};

std::vector<techniques::EmittedFile> parameters(const techniques::TechniqueList& list) {
  std::vector<techniques::EmittedFile> files;
  for (const techniques::ParameterStruct& one : list.structs) {
    files.push_back(techniques::emit_hlsl(one));
    files.push_back(techniques::emit_csharp(one));
  }
  return files;
}

const std::array<EmittedFolder, 2>& emitted_folders() {
  static const std::array<EmittedFolder, 2> folders{
      {{"--emit-parameters", &EmittedFiles::parameters,
        "Every parameter struct as HLSL beside its manifest and as C# in Runtime/Parameters, in this folder "
        "of "
        "a package",
        parameters},
       {"--emit-graphs", &EmittedFiles::graphs,
        "Every manifest's graphs of passes as C# in Runtime/Techniques, in this folder of a package",
        techniques::emit_graphs_csharp}}};
  return folders;
}

// A source file of the user's own is not replaced; a file that this program wrote says so in its text.
void refuse_foreign_source(const std::string& file, std::string_view emitted) {
  constexpr std::string_view kMark = "Written by `penumbra";
  std::error_code ignored;
  if (file.empty() || file == "-" || !fs::is_regular_file(file, ignored)) return;
  if (emitted.find(kMark) == std::string_view::npos) {
    refuse_report_over_source("--emit-...", file);
  } else if (fs::file_size(file, ignored) > 0 && read_text_file(file).find(kMark) == std::string::npos) {
    throw InputError(file, "exists and was not written by penumbra",
                     "move it, or delete it if what is written now is meant to replace it");
  }
}

// A package may come from an untrusted source, and its links would lead the output elsewhere. The package's
// own folder may be a link: the user names it.
void refuse_link(const fs::path& package, const fs::path& file) {
  if (const std::optional<fs::path> link = platform::link_below(package, package / file))
    throw InputError(link->string(), "is a symbolic link, which output does not follow",
                     "put the folder or file itself there");
}

// All folders are created, and all files are checked, before the first file is written.
void write_folder(const fs::path& package, const std::vector<techniques::EmittedFile>& files) {
  for (const techniques::EmittedFile& emitted : files) refuse_link(package, emitted.file);
  for (const techniques::EmittedFile& emitted : files) {
    const fs::path folder = (package / emitted.file).parent_path();
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw InputError(folder.string(), "the folder cannot be made: " + error.message());
    refuse_foreign_source((package / emitted.file).string(), emitted.text);
  }
  for (const techniques::EmittedFile& emitted : files)
    write_output((package / emitted.file).string(), emitted.text);
}

}  // namespace

bool EmittedFiles::any() const {
  bool asked = false;
  for (const EmittedFolder& emitted : emitted_folders()) asked = asked || !(this->*emitted.folder).empty();
  for (const EmittedFile& emitted : emitted_files()) asked = asked || !(this->*emitted.file).empty();
  return asked;
}

void add_emitted_options(CLI::App& command, EmittedFiles& files) {
  for (const EmittedFolder& emitted : emitted_folders())
    command.add_option(emitted.option, files.*emitted.folder, emitted.description)
        ->type_name("FOLDER")
        ->default_str("none")
        ->group(kGroup);
  for (const EmittedFile& emitted : emitted_files())
    command.add_option(emitted.option, files.*emitted.file, emitted.description)
        ->type_name("FILE")
        ->default_str("none")
        ->group(kGroup);
}

void check_emitted(const EmittedFiles& files, const std::string& technique_list) {
  for (const EmittedFolder& emitted : emitted_folders())
    if (!(files.*emitted.folder).empty()) check_output_folder(files.*emitted.folder);
  for (const EmittedFile& emitted : emitted_files()) {
    check_output_file(files.*emitted.file);
    refuse_input_as_output(emitted.option, files.*emitted.file, {technique_list});
  }
}

void write_emitted(const EmittedFiles& files, const techniques::TechniqueList& list) {
  for (const EmittedFolder& emitted : emitted_folders())
    if (!(files.*emitted.folder).empty()) write_folder(files.*emitted.folder, emitted.files(list));
  for (const EmittedFile& emitted : emitted_files()) {
    const std::string& file = files.*emitted.file;
    if (file.empty()) continue;
    const std::string text = emitted.text(list);
    refuse_foreign_source(file, text);
    write_output(file, text);
  }
}

}  // namespace penumbra::cli
