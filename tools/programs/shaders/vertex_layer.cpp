#include "shaders/vertex_layer.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace penumbra::shaders {

namespace {

std::optional<spvc_variable_id> layer_output(const SpirvCrossSession& session, spvc_resources resources) {
  const spvc_reflected_builtin_resource* list = nullptr;
  std::size_t count = 0;
  session.require(spvc_resources_get_builtin_resource_list_for_type(
      resources, SPVC_BUILTIN_RESOURCE_TYPE_STAGE_OUTPUT, &list, &count));
  for (std::size_t i = 0; i < count; ++i)
    if (list[i].builtin == SpvBuiltInLayer) return list[i].resource.id;
  return std::nullopt;
}

unsigned free_location(const SpirvCrossSession& session, spvc_resources resources) {
  const spvc_reflected_resource* list = nullptr;
  std::size_t count = 0;
  session.require(
      spvc_resources_get_resource_list_for_type(resources, SPVC_RESOURCE_TYPE_STAGE_OUTPUT, &list, &count));
  unsigned next = 0;
  for (std::size_t i = 0; i < count; ++i)
    next = std::max(next,
                    1 + spvc_compiler_get_decoration(session.compiler(), list[i].id, SpvDecorationLocation));
  return next;
}

}  // namespace

VertexLayer::VertexLayer(const SpirvCrossSession& session, Target target) {
  const spvc_compiler compiler = session.compiler();
  if (spvc_compiler_get_execution_model(compiler) == SpvExecutionModelGeometry) return;
  spvc_resources resources = nullptr;
  session.require(spvc_compiler_create_shader_resources(compiler, &resources));
  const std::optional<spvc_variable_id> layer = layer_output(session, resources);
  if (!layer) return;
  switch (target_language(target)) {
    case TargetLanguage::essl:
      throw std::invalid_argument(
          "OpenGL ES lets no vertex shader choose the layer (SV_RenderTargetArrayIndex); Unity draws both "
          "eyes "
          "by multiview there");
    case TargetLanguage::glsl:
      session.require(spvc_compiler_require_extension(compiler, "GL_ARB_shader_viewport_layer_array"));
      break;
    case TargetLanguage::hlsl: {  // passes through SPIRV-Cross like any other output
      const unsigned location = free_location(session, resources);
      spvc_compiler_unset_decoration(compiler, *layer, SpvDecorationBuiltIn);
      spvc_compiler_set_decoration(compiler, *layer, SpvDecorationLocation, location);
      stand_in_ = " : TEXCOORD" + std::to_string(location) + ";";
      break;
    }
    case TargetLanguage::msl:
      break;
  }
}

std::string VertexLayer::completed(std::string text) const {
  if (stand_in_.empty()) return text;
  // Vertex inputs are TEXCOORDs, too: only the one in the output structure is replaced.
  const std::size_t outputs = text.find("struct SPIRV_Cross_Output");
  const std::size_t at = text.find(stand_in_, outputs);
  if (outputs == std::string::npos || at == std::string::npos || at > text.find('}', outputs))
    throw std::invalid_argument("the layer's output is not in the text that SPIRV-Cross emitted");
  return text.replace(at, stand_in_.size(), " : SV_RenderTargetArrayIndex;");
}

}  // namespace penumbra::shaders
