#include "resolve/technique_uniforms.h"

#include <glm/vec4.hpp>

#include "techniques/parameter_packing.h"

namespace penumbra::resolve {

UniformValues parameter_uniforms(const techniques::TechniqueList& list,
                                 const techniques::Technique& technique, Taps taps) {
  std::map<std::string, std::vector<double>> values = technique.values;
  if (taps == Taps::unlimited)
    for (const auto& [field, number] : technique.unlimited) values[field] = {number};
  UniformValues uniforms;
  for (const techniques::ParameterStruct* parameters : list.structs_of(technique)) {
    const std::vector<std::array<float, 4>> vectors = techniques::packed(*parameters, values);
    for (std::size_t i = 0; i < vectors.size(); ++i)
      uniforms.set(techniques::uniform_name(*parameters, i),
                   glm::vec4(vectors[i][0], vectors[i][1], vectors[i][2], vectors[i][3]));
  }
  return uniforms;
}

}  // namespace penumbra::resolve
