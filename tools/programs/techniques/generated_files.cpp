#include "techniques/generated_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "input/input_error.h"
#include "input/text_file.h"
#include "shaders/package_shader.h"
#include "techniques/feature_tables.h"
#include "techniques/golden_json.h"
#include "techniques/parameter_emit.h"
#include "techniques/selection_hlsl.h"
#include "techniques/settings_emit.h"

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

// The package's structs are one file of C#, those of a technique to come one of their manifest.
void add_structs(const TechniqueList& list, bool has_feature, std::vector<EmittedFile>& files) {
  std::map<std::string, std::vector<ParameterStruct>> by_file;
  for (const ParameterStruct& parameters : list.structs) {
    files.push_back(emit_hlsl(parameters));
    const std::string manifest = fs::path(parameters.manifest).stem().stem().string();
    by_file[has_feature ? "TechniqueParameters" : manifest + "Parameters"].push_back(parameters);
  }
  for (const auto& [name, structs] : by_file) files.push_back(emit_csharp(structs, name));
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

// Returns the filter that replaces the one of these keywords below shader target 4.5; null if that one runs
// there itself.
const Selection* instead_of_target_45(const TechniqueList& list, const std::vector<std::string>& keywords) {
  for (const Selection& filter : list.selections) {
    const bool is_selected = std::find(keywords.begin(), keywords.end(), filter.keyword) != keywords.end();
    if (!is_selected || !filter.needs_target_45) continue;
    for (const Selection& other : list.selections)
      if (other.name == filter.fallback) return &other;
  }
  return nullptr;
}

}  // namespace

std::vector<EmittedFile> generated_files(const TechniqueList& list) {
  if (!list.addition.empty()) return files_of_addition(list);
  std::vector<EmittedFile> files;
  std::error_code error;
  const bool has_feature = fs::exists(list.package / kFeatureShader, error);
  if (!has_feature) add_graphs(list, files);
  add_structs(list, has_feature, files);
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

std::vector<PresetProgram> programs_of(const TechniqueList& list, const Technique& preset,
                                       const shaders::PackageShader& shader) {
  std::vector<PresetProgram> programs;
  const std::vector<std::string> passes = shader.pass_names();
  const auto add = [&](const std::string& pass, const std::vector<std::string>& keywords) {
    const PresetProgram program{pass, shader.declared(pass, keywords)};
    if (std::find(programs.begin(), programs.end(), program) == programs.end()) programs.push_back(program);
  };
  const auto add_passes = [&](const Technique& technique) {
    const std::vector<std::string> keywords = technique.all_keywords();
    const Selection* tent = instead_of_target_45(list, keywords);
    for (const GraphPass& pass : technique.graph.passes) {
      if (pass.kind == PassKind::compute ||
          std::find(passes.begin(), passes.end(), pass.program) == passes.end())
        continue;
      add(pass.program, keywords);
      // The tent filter has no mask.
      if (tent != nullptr && !shader.declared(pass.program, {tent->keyword}).empty())
        add(pass.program, {tent->keyword});
    }
  };
  add_passes(preset);
  for (const PresetChoice& choice : list.presets)
    if (choice.preset == preset.name) add_passes(list.find(choice.fallback));
  return programs;
}

std::string preset_programs_json(const TechniqueList& list, const shaders::PackageShader& shader) {
  std::uint64_t all = 0;
  for (const std::string& pass : shader.pass_names()) all += shader.variant_count(pass);
  nlohmann::ordered_json json{
      {"shader", shader.name()}, {"programs", all}, {"presets", nlohmann::ordered_json::array()}};
  for (const Technique& technique : list.techniques) {
    if (!technique.name.starts_with(preset_prefix)) continue;
    nlohmann::ordered_json programs = nlohmann::ordered_json::array();
    for (const PresetProgram& program : programs_of(list, technique, shader))
      programs.push_back({{"pass", program.pass}, {"keywords", program.keywords}});
    json["presets"].push_back(
        {{"name", technique.name}, {"title", technique.title}, {"programs", std::move(programs)}});
  }
  return json.dump(2) + "\n";
}

}  // namespace penumbra::techniques
