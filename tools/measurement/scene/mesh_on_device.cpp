#include "scene/mesh_on_device.h"

#include "input/input_error.h"
#include "platform/data_directory.h"

namespace penumbra::scene {
namespace {

// A buffer cannot be empty, even where no cut-out reads it.
template <typename Element>
gpu::Buffer filled(const gpu::Device& device, const std::vector<Element>& content) {
  static const std::vector<Element> one(1);
  return {device, std::span<const Element>(content.empty() ? one : content)};
}

}  // namespace

MeshOnDevice::CutOutTables::CutOutTables(const gpu::Device& device, const Mesh& mesh, const CutOuts& cut_outs)
    : coordinates(
          filled(device, mesh.uvs.empty() ? std::vector<glm::vec2>(mesh.positions.size()) : mesh.uvs)),
      of_triangle(filled(device, cut_outs.of_triangle())),
      entries(filled(device, cut_outs.entries())),
      texels(filled(device, cut_outs.texels())) {}

MeshOnDevice::MeshOnDevice(const gpu::Device& device, const Mesh& mesh, const CutOuts& given)
    : positions(device, std::span<const glm::vec3>(mesh.positions)),
      normals(device, std::span<const glm::vec3>(mesh.normals)),
      indices(device, std::span<const std::uint32_t>(mesh.indices)),
      vertex_count(static_cast<std::uint32_t>(mesh.indices.size())) {
  if (given.any()) cut_outs.emplace(device, mesh, given);
}

void MeshOnDevice::bind_to(gpu::Bindings& bindings) const {
  const auto bind = [&](const char* name, const gpu::Buffer& buffer) {
    if (bindings.has(name)) bindings.buffer(name, buffer);
  };
  bind("_Positions", positions);
  bind("_Normals", normals);
  bind("_Indices", indices);
  if (!cut_outs) return;
  bind("_TexCoords", cut_outs->coordinates);
  bind("_CutOutOfTriangle", cut_outs->of_triangle);
  bind("_CutOuts", cut_outs->entries);
  bind("_CutOutTexels", cut_outs->texels);
}

std::vector<std::uint32_t> compile_scene_shader(const SceneShader& shader) {
  const std::filesystem::path root = platform::data_directory();
  const auto flag = [](bool value) { return std::string(value ? "1" : "0"); };
  shaders::CompileRequest request;
  request.file = root / "tools" / "measurement" / "scene" / "shaders" / shader.file;
  request.entry = shader.entry;
  request.stage = shader.stage;
  request.defines = {{"UNITY_REVERSED_Z", flag(shader.reversed_z)},
                     {"PENUMBRA_CUT_OUTS", flag(shader.cut_outs)}};
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
