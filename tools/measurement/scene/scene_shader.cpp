#include "scene/scene_shader.h"

#include "input/input_error.h"
#include "platform/data_directory.h"

namespace penumbra::scene {

std::vector<std::uint32_t> compile_scene_shader(const SceneShader& shader) {
  const std::filesystem::path root = platform::data_directory();
  const auto flag = [](bool value) { return std::string(value ? "1" : "0"); };
  shaders::CompileRequest request;
  request.file = root / "tools" / "measurement" / "scene" / "shaders" / shader.file;
  request.entry = shader.entry;
  request.stage = shader.stage;
  request.defines = {{"UNITY_REVERSED_Z", flag(shader.reversed_z)},
                     {"PENUMBRA_CUT_OUTS", flag(shader.cut_outs)},
                     {"PENUMBRA_SPOT_LIGHT", flag(shader.spot_light)}};
  request.include_directories = {root / "ShaderLibrary"};
  shaders::CompileResult result = shaders::compile(request);
  if (!hlsl::has_errors(result.diagnostics)) return std::move(result.spirv);
  std::string messages = "a shader of the program itself does not compile:";
  for (const hlsl::Diagnostic& diagnostic : result.diagnostics) {
    messages += "\n" + hlsl::format(diagnostic);
  }
  throw EnvironmentError(messages);
}

}  // namespace penumbra::scene
