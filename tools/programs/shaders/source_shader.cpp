#include "shaders/source_shader.h"

#include <glslang/Public/ResourceLimits.h>

namespace penumbra::shaders {

namespace {

// glslang defines this name for GLSL; in HLSL it is a name like any other, which shaders use for keywords.
constexpr const char* forgotten = "#undef VULKAN\n";

// Returns the parser's log for another text in place of the source's.
std::string log_of(const Source& source, const std::string& text) {
  glslang::TShader::ForbidIncluder nothing_left_to_include;
  const Source instead{source.request, source.name, text};
  SourceShader shader(instead);
  shader.get().parse(GetDefaultResources(), hlsl_version, false, messages_of(source.request),
                     nothing_left_to_include);
  return shader.get().getInfoLog();
}

}  // namespace

EShMessages messages_of(const CompileRequest& request) {
  const int half = request.half_is_16_bits ? EShMsgHlslEnable16BitTypes : EShMsgDefault;
  return static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules | EShMsgReadHlsl | half);
}

EShLanguage language(hlsl::Stage stage) {
  switch (stage) {
    case hlsl::Stage::vertex:
      return EShLangVertex;
    case hlsl::Stage::hull:
      return EShLangTessControl;
    case hlsl::Stage::domain:
      return EShLangTessEvaluation;
    case hlsl::Stage::geometry:
      return EShLangGeometry;
    case hlsl::Stage::fragment:
      return EShLangFragment;
    case hlsl::Stage::compute:
      break;
  }
  return EShLangCompute;
}

SourceShader::SourceShader(const Source& source)
    : texts_{source.text.data()},
      names_{source.name.c_str()},
      lengths_{static_cast<int>(source.text.size())},
      shader_(language(source.request.stage)) {
  shader_.setStringsWithLengthsAndNames(texts_, lengths_, names_, 1);
  shader_.setPreamble(forgotten);
  shader_.setEntryPoint(source.request.entry.c_str());
  shader_.setSourceEntryPoint(source.request.entry.c_str());
  shader_.setEnvInput(glslang::EShSourceHlsl, language(source.request.stage), glslang::EShClientVulkan, 100);
  // Vulkan 1.2 accepts SPIR-V 1.3; glslang's HLSL front end does not produce valid SPIR-V 1.4 and later.
  const bool oldest = source.request.vulkan == VulkanVersion::v1_0;
  shader_.setEnvClient(glslang::EShClientVulkan,
                       oldest ? glslang::EShTargetVulkan_1_0 : glslang::EShTargetVulkan_1_1);
  shader_.setEnvTarget(glslang::EShTargetSpv, oldest ? glslang::EShTargetSpv_1_0 : glslang::EShTargetSpv_1_3);
  shader_.setAutoMapBindings(true);
  shader_.setAutoMapLocations(true);
}

ParseFailure failure_of(const Source& source, const std::string& log, const std::string& expanded) {
  return {log, source.name, expanded, [&source](const std::string& text) { return log_of(source, text); }};
}

}  // namespace penumbra::shaders
