#include "scene/scene_shader.h"

#include "input/input_error.h"
#include "platform/data_directory.h"

namespace penumbra::scene {

std::vector<std::uint32_t> compile_scene_shader(const std::string& file, const std::string& entry,
                                                hlsl::Stage stage, bool reversed_z) {
  const std::filesystem::path root = platform::data_directory();
  shaders::CompileRequest request;
  request.file = root / "tools" / "scene" / "shaders" / file;
  request.entry = entry;
  request.stage = stage;
  request.defines = {{"UNITY_REVERSED_Z", reversed_z ? "1" : "0"}};
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
