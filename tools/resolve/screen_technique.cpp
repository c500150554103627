#include "resolve/screen_technique.h"

namespace penumbra::resolve {
namespace {

float value_of(const techniques::Technique& technique, const char* field) {
  const auto found = technique.values.find(field);
  return found == technique.values.end() ? 0.0f : static_cast<float>(found->second.front());
}

// Of the passes before and after Resolve; what a technique does not have is 0.
UniformValues screen_uniforms(const techniques::Technique& technique) {
  const auto of = [&](const char* field) { return value_of(technique, field); };
  UniformValues values;
  values.set("_PenumbraMaskParams",
             glm::vec4(of("maskPenumbraMetres"), of("maskFilterTexels"), of("maskLargestRadius"), 0.0f));
  values.set("_PenumbraDenoiseParams",
             glm::vec4(of("denoiseRadius"), of("planeTolerance"), of("noiseAmplitude"), 0.0f));
  return values;
}

// The pass that writes what the pass calls so; -1: none.
int writer_of(const techniques::Technique& technique, const techniques::GraphPass& pass,
              const char* shader_name) {
  for (const auto& [name, texture] : pass.reads) {
    if (name != shader_name) continue;
    for (std::size_t i = 0; i < technique.graph.passes.size(); ++i)
      if (technique.graph.passes[i].writes.front().second == texture) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace

UniformValues shadows_uniforms(const techniques::Technique& technique) {
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

ScreenChainDescription screen_chain(const techniques::Technique& technique) {
  ScreenChainDescription chain;
  chain.keywords = technique.all_keywords();
  chain.parameters = shadows_uniforms(technique);
  chain.parameters.merge(screen_uniforms(technique));
  chain.uses_noise = !technique.unlimited.empty();
  const techniques::PassGraph& graph = technique.graph;
  for (const techniques::GraphPass& pass : graph.passes) {
    const std::string& target = pass.writes.front().second;
    if (target == graph.mask) chain.mask = static_cast<int>(chain.steps.size());
    chain.steps.push_back(
        {pass.program, graph.texture(target)->divisor, writer_of(technique, pass, "_PenumbraSourceTexture")});
  }
  return chain;
}

}  // namespace penumbra::resolve
