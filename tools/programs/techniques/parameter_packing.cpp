#include "techniques/parameter_packing.h"

namespace penumbra::techniques {

std::vector<PackedPlace> packed_places(const ParameterStruct& parameters) {
  std::vector<PackedPlace> places;
  std::size_t next = 0;
  for (const ParameterField& field : parameters.fields) {
    const std::size_t count = component_count(field);
    if (next % 4 + count > 4) next += 4 - next % 4;
    places.push_back({next / 4, next % 4});
    next += count;
  }
  return places;
}

std::size_t vector_count(const ParameterStruct& parameters) {
  return parameters.fields.empty() ? 0 : packed_places(parameters).back().vector + 1;
}

std::string uniform_name(const ParameterStruct& parameters, std::size_t vector) {
  return "_Penumbra" + parameters.name + std::to_string(vector);
}

std::vector<std::array<float, 4>> packed(const ParameterStruct& parameters,
                                         const std::map<std::string, std::vector<double>>& values) {
  std::vector<std::array<float, 4>> vectors(vector_count(parameters));
  const std::vector<PackedPlace> places = packed_places(parameters);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::vector<double>& value = values.at(parameters.fields[i].name);
    for (std::size_t k = 0; k < component_count(parameters.fields[i]); ++k)
      vectors[places[i].vector][places[i].component + k] = static_cast<float>(value.at(k));
  }
  return vectors;
}

std::size_t component_count(const ParameterField& field) {
  if (field.type == "float2") return 2;
  return field.type == "float4" ? 4 : 1;
}

}  // namespace penumbra::techniques
