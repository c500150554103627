#include "techniques/preset_programs.h"

#include <nlohmann/json.hpp>

#include "techniques/preset_emit.h"

namespace penumbra::techniques {

std::vector<PresetProgram> programs_of(const Technique& preset, const shaders::PackageShader& shader) {
  std::vector<PresetProgram> programs;
  for (const GraphPass& pass : preset.graph.passes)
    programs.push_back({pass.program, shader.declared(pass.program, preset.all_keywords())});
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
    for (const PresetProgram& program : programs_of(technique, shader))
      programs.push_back({{"pass", program.pass}, {"keywords", program.keywords}});
    json["presets"].push_back(
        {{"name", technique.name}, {"title", technique.title}, {"programs", std::move(programs)}});
  }
  return json.dump(2) + "\n";
}

}  // namespace penumbra::techniques
