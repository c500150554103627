#include "techniques/packing_cases.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

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
  for (const double share : {0.0, 1.0, 0.5})
    add([&](const ParameterField& f, std::size_t) { return between(f, share); });
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

}  // namespace

std::string packing_cases_json(const TechniqueList& list) {
  Json json = Json::object();
  for (const ParameterStruct& parameters : list.structs) json[parameters.name] = cases(parameters);
  return json_lines(json.dump());
}

}  // namespace penumbra::techniques
