#include "resolve/screen_technique.h"

#include <algorithm>

#include "shaders/technique_chain.h"

namespace penumbra::resolve {
namespace {

float value_of(const shaders::Technique& technique, const char* field) {
  const auto found = technique.values.find(field);
  return found == technique.values.end() ? 0.0f : static_cast<float>(found->second.front());
}

// Of the passes before and after Resolve; what a technique does not have is 0.
UniformValues screen_uniforms(const shaders::Technique& technique) {
  const auto of = [&](const char* field) { return value_of(technique, field); };
  UniformValues values;
  values.set("_PenumbraMaskParams",
             glm::vec4(of("maskPenumbraMetres"), of("maskFilterTexels"), of("maskLargestRadius"), 0.0f));
  values.set("_PenumbraDenoiseParams",
             glm::vec4(of("denoiseRadius"), of("planeTolerance"), of("noiseAmplitude"), 0.0f));
  return values;
}

bool reads_source(const shaders::TechniquePass& pass) {
  const std::vector<std::string>& resources = shaders::pass_kind(pass.kind).resources;
  return std::find(resources.begin(), resources.end(), "source") != resources.end();
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

ScreenChainDescription screen_chain(const shaders::Technique& technique) {
  ScreenChainDescription chain;
  chain.keywords = technique.keywords;
  const std::vector<std::string> of_the_chain = shaders::chain_keywords(technique);
  chain.keywords.insert(chain.keywords.end(), of_the_chain.begin(), of_the_chain.end());
  chain.parameters = shadows_uniforms(technique);
  chain.parameters.merge(screen_uniforms(technique));
  chain.uses_noise = !technique.unlimited.empty();
  for (const shaders::TechniquePass& pass : technique.chain) {
    for (const std::string& name : shaders::pass_kind(pass.kind).shader_passes) {
      const int before = static_cast<int>(chain.steps.size()) - 1;
      chain.steps.push_back({name, pass.scale, reads_source(pass) ? before : -1});
    }
    if (pass.kind == "mask-blur") chain.mask = static_cast<int>(chain.steps.size()) - 1;
  }
  return chain;
}

}  // namespace penumbra::resolve
