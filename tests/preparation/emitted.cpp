#include "preparation/emitted.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <stdexcept>

#include "shaders/compile.h"

namespace penumbra::preparation {
namespace {

constexpr unsigned first_storage_binding = 8;  // GL counts buffers of each kind from 0, Vulkan all together

std::vector<std::uint32_t> compiled_hlsl(const std::string& text) {
  shaders::CompileRequest request;
  request.file = "emitted.hlsl";
  request.text = text;
  request.entry = "main";
  shaders::CompileResult result = shaders::compile(request);
  if (!hlsl::has_errors(result.diagnostics)) return std::move(result.spirv);
  throw std::runtime_error(format(result.diagnostics.at(0)) + "\n" + text);
}

std::vector<std::uint32_t> compiled_glsl(const std::string& text) {
  glslang::TShader shader(EShLangCompute);
  const char* texts[] = {text.c_str()};
  shader.setStrings(texts, 1);
  shader.setEnvInput(glslang::EShSourceGlsl, EShLangCompute, glslang::EShClientVulkan, 100);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
  shader.setShiftBinding(glslang::EResSsbo, first_storage_binding);
  shader.setAutoMapBindings(true);
  const auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
  glslang::TProgram program;
  const bool parsed = shader.parse(GetDefaultResources(), 450, false, messages);
  program.addShader(&shader);
  if (!parsed || !program.link(messages) || !program.mapIO())
    throw std::runtime_error(std::string(shader.getInfoLog()) + program.getInfoLog() + text);
  std::vector<unsigned int> words;
  glslang::GlslangToSpv(*program.getIntermediate(EShLangCompute), words);
  return {words.begin(), words.end()};
}

}  // namespace

std::vector<std::uint32_t> through_target(const std::vector<std::uint32_t>& spirv, shaders::Target target) {
  const shaders::CrossCompileResult emitted = shaders::cross_compile(spirv, target);
  if (!emitted.diagnostics.empty()) throw std::runtime_error(format(emitted.diagnostics.front()));
  return shaders::target_language(target) == shaders::TargetLanguage::hlsl ? compiled_hlsl(emitted.text)
                                                                           : compiled_glsl(emitted.text);
}

}  // namespace penumbra::preparation
