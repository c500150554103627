#include "resolve/shadow_shader.h"

#include <algorithm>

#include "input/input_error.h"
#include "platform/data_directory.h"
#include "project/include_bounds.h"
#include "techniques/technique_call.h"

namespace penumbra::resolve {
namespace {

std::vector<std::pair<std::string, std::string>> depth_defines(bool reversed_z) {
  if (reversed_z) return {{"UNITY_REVERSED_Z", "1"}};
  return {};
}

// The platform macros come with the body, so that an adapter may bring its pipeline's instead; where it
// brings none, the harness still has to have some.
std::string whole_source(const ShadowShader& shader) {
  return shader.body + "#include \"Platform/Platform.hlsl\"\n#include \"Resolve.hlsl\"\n";
}

// This library under the name it has in Unity, unless the user brings a version of it.
std::vector<shaders::PackageRoot> with_own_package(std::vector<shaders::PackageRoot> roots) {
  const std::string name = "com.penumbra.shadows";
  const bool given = std::any_of(roots.begin(), roots.end(),
                                 [&](const shaders::PackageRoot& root) { return root.name == name; });
  if (!given) roots.push_back({name, platform::data_directory()});
  return roots;
}

shaders::CompileRequest request(const ShadowShader& shader) {
  const std::filesystem::path root = platform::data_directory();
  shaders::CompileRequest request;
  request.file = shader.name + ".hlsl";
  request.text = whole_source(shader);
  request.written_for = shader.written_for;
  request.defines = shader.defines;
  request.package_roots = with_own_package(shader.package_roots);
  request.include_directories = shader.include_directories;
  request.include_directories.push_back(root / "ShaderLibrary");
  request.include_directories.push_back(root / "tools" / "measurement" / "resolve" / "shaders");
  request.project = shader.project;
  request.cginc_root = shader.cginc_root;
  request.prepare = shader.prepare;
  if (shader.fragment) {
    request.stage = hlsl::Stage::fragment;
    request.entry = "ResolveFragment";
  }
  return request;
}

shaders::CompileRequest triangle_request() {
  shaders::CompileRequest request;
  request.file =
      platform::data_directory() / "tools" / "measurement" / "resolve" / "shaders" / "ReceiverTriangle.hlsl";
  request.stage = hlsl::Stage::vertex;
  request.entry = "ReceiverTriangle";
  return request;
}

}  // namespace

ShadowShader technique_shader(const techniques::TechniqueList& list, const techniques::Technique& technique,
                              Taps taps, bool reversed_z, techniques::LightKind light) {
  ShadowShader shader;
  shader.name = technique.name;
  shader.written_for = list.package / technique.file();
  shader.include_directories = list.include_directories();
  shader.body = techniques::emit_technique_call(list, technique).source();
  shader.defines = depth_defines(reversed_z);
  for (const std::string& keyword : technique.keywords) shader.defines.emplace_back(keyword, "1");
  if (light == techniques::LightKind::spot) shader.defines.emplace_back("PENUMBRA_SPOT_LIGHT", "1");
  if (taps == Taps::unlimited) shader.defines.emplace_back("PENUMBRA_UNLIMITED", "1");
  shader.parameters = parameter_uniforms(list, technique, taps);
  shader.uses_noise = technique.is_sampled() && taps == Taps::as_listed;
  return shader;
}

ShadowShader adapter_shader(const Adapter& adapter, bool reversed_z) {
  if (!std::filesystem::is_regular_file(adapter.file)) {
    throw InputError(adapter.file.string(), "no such file", "--adapter takes the name of an HLSL file");
  }
  ShadowShader shader;
  shader.name = adapter.name;
  shader.file = adapter.file;
  shader.body = "#define PENUMBRA_ADAPTER 1\n#include \"" +
                std::filesystem::absolute(adapter.file).generic_string() + "\"\n";
  shader.defines = depth_defines(reversed_z);
  for (const std::string& keyword : adapter.keywords) shader.defines.emplace_back(keyword, "1");
  shader.numbers = adapter.uniforms;
  shader.textures = adapter.textures;
  shader.package_roots = adapter.package_roots;
  shader.project = adapter.project;
  shader.cginc_root = adapter.cginc_root;
  shader.written_for = std::filesystem::absolute(adapter.file);
  const std::filesystem::path folder = shader.written_for.parent_path();
  if (!project::no_file_owns(folder)) shader.include_directories.push_back(folder);
  shader.fragment = true;
  shader.prepare = true;
  shader.uses_noise = true;
  return shader;
}

ModuleOrder module_order(const ShadowShader& shader) {
  ModuleOrder order;
  order.name = shader.name;
  order.file = shader.file.empty() ? shader.name : shader.file.string();
  order.plain = request(shader);
  order.names_places = true;
  if (shader.fragment) {
    order.vertex = triangle_request();
    order.is_adapter = true;
  }
  return order;
}

}  // namespace penumbra::resolve
