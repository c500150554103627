#include "resolve/screen_technique.h"

#include "resolve/technique_uniforms.h"

namespace penumbra::resolve {
namespace {

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

ScreenChainDescription screen_chain(const techniques::TechniqueList& list,
                                    const techniques::Technique& technique) {
  ScreenChainDescription chain;
  chain.keywords = technique.all_keywords();
  chain.parameters = parameter_uniforms(list, technique);
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
