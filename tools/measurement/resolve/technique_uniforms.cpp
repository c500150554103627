#include "resolve/technique_uniforms.h"

#include <glm/vec4.hpp>

#include "techniques/cascade_rules.h"
#include "techniques/parameter_packing.h"
#include "techniques/technique_call.h"

namespace penumbra::resolve {
namespace {

using Values = std::map<std::string, std::vector<double>>;

Values with_taps(Values values, const std::map<std::string, double>& unlimited, Taps taps) {
  if (taps == Taps::unlimited)
    for (const auto& [field, number] : unlimited) values[field] = {number};
  return values;
}

template <typename Name>
void set_packed(UniformValues& uniforms, const techniques::ParameterStruct& parameters, const Values& values,
                Name name) {
  const std::vector<std::array<float, 4>> vectors = techniques::packed(parameters, values);
  for (std::size_t i = 0; i < vectors.size(); ++i)
    uniforms.set(name(i), glm::vec4(vectors[i][0], vectors[i][1], vectors[i][2], vectors[i][3]));
}

}  // namespace

UniformValues parameter_uniforms(const techniques::TechniqueList& list,
                                 const techniques::Technique& technique, Taps taps) {
  const Values values = with_taps(technique.values, technique.unlimited, taps);
  UniformValues uniforms;
  for (const techniques::ParameterStruct* parameters : list.structs_of(technique))
    set_packed(uniforms, *parameters, values,
               [&](std::size_t i) { return techniques::uniform_name(*parameters, i); });
  for (const techniques::CascadeRule& rule : techniques::compiled_rules(list, technique)) {
    Values of_rule = techniques::values_of(rule, technique);
    if (const techniques::ParameterStruct* parameters = list.find_struct(rule.filter.parameters))
      set_packed(uniforms, *parameters, with_taps(std::move(of_rule), rule.unlimited, taps),
                 [&](std::size_t i) { return techniques::uniform_name(*parameters, i, rule); });
  }
  return uniforms;
}

}  // namespace penumbra::resolve
