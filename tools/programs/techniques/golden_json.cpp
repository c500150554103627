#include "techniques/golden_json.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

#include "input/json_lines.h"
#include "techniques/parameter_packing.h"

namespace penumbra::techniques {

namespace {

using Json = nlohmann::ordered_json;
using Values = std::map<std::string, std::vector<double>>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kLargestFloat = std::numeric_limits<float>::max();

ParameterRange range_of(const ParameterField& field) {
  if (field.range) return *field.range;
  return field.type == "int" ? ParameterRange{-1e6, 1e6} : ParameterRange{-kLargestFloat, kLargestFloat};
}

double as_float(double value) {
  return static_cast<double>(static_cast<float>(value));
}

double kept(const ParameterField& field, double value) {
  const ParameterRange range = range_of(field);
  return as_float(std::isnan(value) ? range.smallest : std::clamp(value, range.smallest, range.largest));
}

// Returns a value at this share of the range, whole where the field is an int.
double between(const ParameterField& field, double share) {
  const ParameterRange range = field.range.value_or(ParameterRange{-1000.0, 1000.0});
  const double value = range.smallest + share * (range.largest - range.smallest);
  return field.type == "int" ? std::round(value) : as_float(value);
}

Json number(double value) {
  return std::isnan(value) ? Json("NaN") : Json(value);
}

Json one_case(const ParameterStruct& parameters,
              const std::function<double(const ParameterField&, std::size_t)>& of) {
  Values given, bounded;
  Json values = Json::object();
  for (std::size_t i = 0; i < parameters.fields.size(); ++i) {
    const ParameterField& field = parameters.fields[i];
    Json numbers = Json::array();
    for (std::size_t k = 0; k < component_count(field); ++k) {
      const double value = of(field, i + k);
      given[field.name].push_back(value);
      bounded[field.name].push_back(kept(field, value));
      numbers.push_back(field.type == "int" ? Json(static_cast<int>(value)) : number(value));
    }
    values[field.name] = numbers.size() == 1 ? numbers.front() : numbers;
  }
  return {{"values", std::move(values)}, {"vectors", packed(parameters, bounded)}};
}

Json cases(const ParameterStruct& parameters) {
  Json all = Json::array();
  const auto add = [&](const std::function<double(const ParameterField&, std::size_t)>& of) {
    all.push_back(one_case(parameters, of));
  };
  add([](const ParameterField& field, std::size_t) {
    return field.otherwise.empty() ? kept(field, 0.0) : as_float(field.otherwise.front());
  });
  // Every field gets another value, so that a mistaken exchange of two is found.
  add([&](const ParameterField& field, std::size_t i) {
    return between(field,
                   (static_cast<double>(i) + 1.0) / (static_cast<double>(parameters.fields.size()) + 2.0));
  });
  add([](const ParameterField& field, std::size_t) { return field.type == "int" ? -1e6 : as_float(-1e30); });
  add([](const ParameterField& field, std::size_t) { return field.type == "int" ? 1e6 : as_float(1e30); });
  add([](const ParameterField& field, std::size_t) { return field.type == "int" ? 2.0 : kNan; });
  return all;
}

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

std::string packing_cases_json(const TechniqueList& list) {
  Json json = Json::object();
  for (const ParameterStruct& parameters : list.structs) json[parameters.name] = cases(parameters);
  return json_lines(json.dump());
}

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
