#include "techniques/preset_programs.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "techniques/preset_emit.h"

namespace penumbra::techniques {
namespace {

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
