#include "validation/variant_counts.h"

#include <nlohmann/json.hpp>

namespace penumbra::validation {
namespace {

using Json = nlohmann::ordered_json;

Json program_json(const SourceProgram& program, const variants::ProgramPlan& plan,
                  const variants::ProgramPlan* what_if) {
  Json json{{"file", program.file}};
  if (!program.shader.empty()) json["shader"] = program.shader;
  if (!program.pass.empty()) json["pass"] = program.pass;
  json["api"] = variants::renderer_name(program.platform.api);
  json["stages"] = Json::array();
  for (std::size_t i = 0; i < plan.stages.size(); ++i) {
    Json stage{{"stage", hlsl::stage_name(plan.stages[i].stage)},
               {"variants", plan.stages[i].variants.value()}};
    if (what_if != nullptr) stage["what_if"] = what_if->stages.at(i).variants.value();
    json["stages"].push_back(std::move(stage));
  }
  return json;
}

}  // namespace

std::string counts_json(const ShaderSources& sources, const VariantCounts& counts) {
  Json json{{"programs", Json::array()}};
  const std::vector<const SourceProgram*> programs = sources.counted();
  for (std::size_t i = 0; i < counts.plan.programs.size(); ++i)
    json["programs"].push_back(program_json(*programs.at(i), counts.plan.programs[i],
                                            counts.what_if ? &counts.what_if->programs.at(i) : nullptr));
  json["results"] = counts.plan.results.value();
  if (counts.what_if) {
    json["what_if"] = counts.what_if->results.value();
    json["condition"] = counts.condition;
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace penumbra::validation
