#include "shaders/preset_programs.h"

#include <nlohmann/json.hpp>

#include "shaders/preset_emit.h"
#include "shaders/technique_chain.h"

namespace penumbra::shaders {

std::vector<PresetProgram> programs_of(const Technique& preset, const PackageShader& shader) {
  std::vector<std::string> on = preset.keywords;
  for (const std::string& keyword : chain_keywords(preset)) on.push_back(keyword);
  std::vector<PresetProgram> programs;
  for (const TechniquePass& pass : preset.chain)
    for (const std::string& name : pass_kind(pass.kind).shader_passes)
      programs.push_back({name, shader.declared(name, on)});
  return programs;
}

std::string preset_programs_json(const TechniqueList& list, const PackageShader& shader) {
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

}  // namespace penumbra::shaders
