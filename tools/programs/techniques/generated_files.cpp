#include "techniques/generated_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>

#include "input/input_error.h"
#include "input/text_file.h"
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

namespace penumbra::techniques {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFeatureShader = "Shaders/PenumbraShadows.shader";
constexpr const char* kStudyVariants = "tests/study/StudyVariants.technique.json";

std::string programs_json(const TechniqueList& list) {
  return preset_programs_json(list, shaders::PackageShader(list.package / kFeatureShader));
}

bool is_of_list(const ParameterStruct& parameters, const TechniqueList& list) {
  return list.addition.empty() || parameters.manifest == list.addition;
}

// C# is of the package that Unity runs. An addition has only the HLSL that its own filters include.
std::vector<EmittedFile> files_of_addition(const TechniqueList& list) {
  std::vector<EmittedFile> files;
  for (const ParameterStruct& parameters : list.structs)
    if (is_of_list(parameters, list)) files.push_back(emit_hlsl(parameters));
  return files;
}

// The tests of C# know the variants of studies, too.
std::string studied_techniques_json(const TechniqueList& list) {
  const fs::path variants = list.package / kStudyVariants;
  std::error_code error;
  return techniques_json(fs::exists(variants, error) ? read_technique_list(variants) : list);
}

struct PackageFile {
  const char* file;
  std::string (*text)(const TechniqueList&);
  bool shipped = true;  // else it is of the repository alone
};

constexpr const char* kTechniqueTable = R"(# Written by `penumbra emit` from {}; do not edit.
# Columns are separated by tabs; TechniqueReader.cs reads them. After the graphs of passes come the techniques.
)";

std::string table(const TechniqueList& list) {
  return fmt::format(kTechniqueTable, "the manifests, *.technique.json") + graph_rows(list) +
         selection_rows(list);
}

// Without the renderer feature, the graphs are those of a technique to come.
void add_graphs(const TechniqueList& list, std::vector<EmittedFile>& files) {
  const std::string rows = graph_rows(list);
  if (rows.empty()) return;
  const fs::path manifest = list.graphs.front().manifest;
  files.push_back({"Runtime/Techniques/" + manifest.stem().stem().string() + ".txt",
                   fmt::format(kTechniqueTable, manifest.generic_string()) + rows});
}

constexpr std::array<PackageFile, 9> kPackageFiles{
    {{"Runtime/Techniques/Techniques.txt", table},
     {"Runtime/Settings/OptionTable.cs", emit_options_csharp},
     {"Runtime/Settings/PresetTable.cs", emit_presets_csharp},
     {"Runtime/Settings/ShadowLook.cs", emit_looks_csharp},
     {"Runtime/Settings/ShadowTechnique.cs", emit_selections_csharp},
     {"ShaderLibrary/Pipelines/TechniqueByKeyword.hlsl", emit_keywords_hlsl},
     {"Documentation~/variants/presets.json", programs_json, false},
     {"tests/golden/parameter_packing.json", packing_cases_json, false},
     {"tests/golden/techniques.json", studied_techniques_json, false}}};

}  // namespace

std::vector<EmittedFile> generated_files(const TechniqueList& list) {
  if (!list.addition.empty()) return files_of_addition(list);
  std::vector<EmittedFile> files;
  std::error_code error;
  const bool has_feature = fs::exists(list.package / kFeatureShader, error);
  if (!has_feature) add_graphs(list, files);
  for (const ParameterStruct& parameters : list.structs) {
    files.push_back(emit_hlsl(parameters));
    files.push_back(emit_csharp(parameters));
  }
  if (!has_feature) return files;
  for (const PackageFile& made : kPackageFiles)
    if (made.shipped || fs::is_directory((list.package / made.file).parent_path(), error))
      files.push_back({made.file, made.text(list)});
  return files;
}

void refuse_outdated_parameters(const TechniqueList& list) {
  for (const ParameterStruct& parameters : list.structs) {
    if (!is_of_list(parameters, list)) continue;
    const EmittedFile emitted = emit_hlsl(parameters);
    const fs::path file = (list.package / emitted.file).lexically_normal();
    std::error_code error;
    if (!fs::is_regular_file(file, error)) continue;
    const std::string found = read_found_text_file(file);
    if (found == emitted.text || found.find("Written by `penumbra emit`") == std::string::npos) continue;
    const auto same = std::mismatch(found.begin(), found.end(), emitted.text.begin(), emitted.text.end());
    const auto line = 1 + std::count(found.begin(), same.first, '\n');
    throw InputError(
        file.string() + ":" + std::to_string(line),
        "was not made of " + parameters.manifest + " as it is now",
        "write it again: penumbra emit --technique-list " + (list.package / parameters.manifest).string());
  }
}

}  // namespace penumbra::techniques
