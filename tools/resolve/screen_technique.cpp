#include "resolve/screen_technique.h"

namespace penumbra::resolve {
namespace {

float value_of(const shaders::Technique& technique, const char* field) {
  const auto found = technique.values.find(field);
  return found == technique.values.end() ? 0.0f : static_cast<float>(found->second.front());
}

}  // namespace

UniformValues shadows_uniforms(const shaders::Technique& technique) {
  const auto of = [&](const char* field) { return value_of(technique, field); };
  UniformValues values;
  // Classic PCSS has one count for both loops and calls it `samples`: one of the two is 0.
  values.set("_PenumbraSamples", glm::vec4(of("blockerSamples") + of("samples"), of("filterSamples"),
                                           of("blockerClump"), of("minFilterTexels")));
  values.set("_PenumbraLimits",
             glm::vec4(of("maxPenumbraMetres"), of("maxSamplingMetres"), of("searchRadiusMetres"), 0.0f));
  values.set("_PenumbraHdrp", glm::vec4(of("searchTanHalf"), of("minFilterTanHalf"), 0.0f, 0.0f));
  return values;
}

}  // namespace penumbra::resolve
