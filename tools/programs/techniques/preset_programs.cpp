#include "techniques/preset_programs.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "techniques/preset_emit.h"

namespace penumbra::techniques {

std::vector<PresetProgram> programs_of(const TechniqueList& list, const Technique& preset,
                                       const shaders::PackageShader& shader) {
  std::vector<PresetProgram> programs;
  const std::vector<std::string> passes = shader.pass_names();
  const auto add = [&](const Technique& technique) {
    for (const GraphPass& pass : technique.graph.passes) {
      if (pass.kind == PassKind::compute ||
          std::find(passes.begin(), passes.end(), pass.program) == passes.end())
        continue;
      const PresetProgram program{pass.program, shader.declared(pass.program, technique.all_keywords())};
      if (std::find(programs.begin(), programs.end(), program) == programs.end()) programs.push_back(program);
    }
  };
  add(preset);
  for (const PresetChoice& choice : list.presets)
    if (choice.preset == preset.name) add(list.find(choice.fallback));
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
