#include "techniques/technique_json.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "input/json_lines.h"

namespace penumbra::techniques {
namespace {

using Json = nlohmann::ordered_json;

Json of(const GraphTexture& texture) {
  Json json{{"name", texture.name},     {"extent", name_of(texture.extent)}, {"divisor", texture.divisor},
            {"size", texture.size},     {"format", texture.format},          {"mips", texture.mips},
            {"layers", texture.layers}, {"samples", texture.samples}};
  if (!texture.previous_of.empty()) json["previous_of"] = texture.previous_of;
  return json;
}

Json of(const GraphPass& pass) {
  Json reads = Json::object();
  for (const auto& [shader_name, name] : pass.reads) reads[shader_name] = name;
  Json writes = Json::array();
  for (const auto& [shader_name, name] : pass.writes) writes.push_back(name);
  Json json{{"name", pass.name},
            {"kind", name_of(pass.kind)},
            {"runs", name_of(pass.frequency)},
            {"file", pass.file},
            {"program", pass.program},
            {"reads", std::move(reads)},
            {"writes", std::move(writes)},
            {"function", pass.filter ? pass.filter->function : ""}};
  if (!pass.absent.empty()) json["absent"] = pass.absent;
  if (!pass.depth.empty()) json["depth"] = pass.depth;
  if (!pass.updates.empty()) json["updates"] = pass.updates;
  if (!pass.stencil.empty()) json["stencil"] = pass.stencil;
  if (pass.casters != DrawnCasters::opaque) json["casters"] = name_of(pass.casters);
  return json;
}

Json of(const std::map<std::string, std::vector<double>>& numbers_by_field) {
  Json values = Json::object();
  for (const auto& [field, numbers] : numbers_by_field) {
    if (numbers.size() == 1)
      values[field] = numbers.front();
    else
      values[field] = numbers;
  }
  return values;
}

Json of(const Technique& technique) {
  Json textures = Json::array();
  for (const GraphTexture& texture : technique.graph.textures) textures.push_back(of(texture));
  Json passes = Json::array();
  for (const GraphPass& pass : technique.graph.passes) passes.push_back(of(pass));
  Json json{{"name", technique.name},
            {"title", technique.title},
            {"family", technique.family},
            {"source", technique.source},
            {"keywords", technique.all_keywords()},
            {"values", of(technique.values)},
            {"textures", std::move(textures)},
            {"passes", std::move(passes)}};
  for (const Need need : technique.graph.needs) json["needs"].push_back(name_of(need));
  for (const CascadeRule& rule : technique.cascades)
    json["cascades"].push_back({{"from", rule.from},
                                {"technique", rule.technique},
                                {"function", rule.filter.function},
                                {"values", of(rule.values)}});
  return json;
}

}  // namespace

std::string techniques_json(const TechniqueList& list) {
  Json json{{"structs", Json::array()}, {"techniques", Json::array()}, {"looks", Json::array()}};
  for (const ParameterStruct& parameters : list.structs) {
    Json fields = Json::array();
    for (const ParameterField& field : parameters.fields)
      fields.push_back({{"name", field.name}, {"type", field.type}});
    json["structs"].push_back({{"name", parameters.name}, {"fields", std::move(fields)}});
  }
  for (const Technique& technique : list.techniques) json["techniques"].push_back(of(technique));
  for (const Look& look : list.looks)
    json["looks"].push_back({{"name", look.name},
                             {"title", look.title},
                             {"doc", look.doc},
                             {"angularDiameterDegrees", look.angular_diameter_degrees},
                             {"maxPenumbraMetres", look.max_penumbra_metres}});
  return json_lines(json.dump());
}

}  // namespace penumbra::techniques
