#include "resolve/shadow_shader.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "input/input_error.h"
#include "platform/data_directory.h"
#include "resolve/adapter_checks.h"
#include "resolve/counted_modules.h"
#include "shaders/reflect.h"

namespace penumbra::resolve {
namespace {

constexpr const char* kUniformPrefix = "_Penumbra";

std::vector<std::pair<std::string, std::string>> depth_defines(bool reversed_z) {
  if (reversed_z) return {{"UNITY_REVERSED_Z", "1"}};
  return {};
}

// A field's value as its uniform reads it: int, or one to four floats.
void set_parameter(UniformValues& values, const shaders::ParameterField& field, const std::string& uniform,
                   const std::vector<double>& value) {
  if (field.type == "int") {
    values.set(uniform, static_cast<int>(std::lround(value.at(0))));
    return;
  }
  glm::vec4 vector(0.0f);
  for (std::size_t i = 0; i < std::min<std::size_t>(4, value.size()); ++i) {
    vector[static_cast<int>(i)] = static_cast<float>(value[i]);
  }
  values.set(uniform, vector);
}

UniformValues parameter_values(const shaders::TechniqueList& list, const shaders::Technique& technique,
                               Taps taps) {
  UniformValues values;
  for (const shaders::TechniquePass& pass : technique.chain) {
    const shaders::ParameterStruct* parameters = list.find_struct(pass.parameters);
    if (parameters == nullptr) continue;
    for (const shaders::ParameterField& field : parameters->fields) {
      std::vector<double> value = technique.values.at(field.name);
      const auto unlimited = technique.unlimited.find(field.name);
      if (taps == Taps::unlimited && unlimited != technique.unlimited.end()) {
        value = {std::stod(unlimited->second)};
      }
      set_parameter(values, field, kUniformPrefix + parameters->name + "_" + field.name, value);
    }
  }
  return values;
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

shaders::CompileRequest request(const ShadowShader& shader, bool counting) {
  const std::filesystem::path root = platform::data_directory();
  shaders::CompileRequest request;
  request.file = shader.name + (counting ? " (counting).hlsl" : ".hlsl");
  request.text = whole_source(shader);
  request.defines = shader.defines;
  request.package_roots = with_own_package(shader.package_roots);
  request.include_directories = shader.include_directories;
  request.include_directories.push_back(root / "ShaderLibrary");
  request.include_directories.push_back(root / "tools" / "resolve" / "shaders");
  request.project = shader.project;
  request.cginc_root = shader.cginc_root;
  request.prepare = shader.prepare;
  if (shader.fragment) {
    request.stage = hlsl::Stage::fragment;
    request.entry = "ResolveFragment";
  }
  if (counting) count_fetches(request);
  return request;
}

shaders::CompileRequest triangle_request() {
  shaders::CompileRequest request;
  request.file = platform::data_directory() / "tools" / "resolve" / "shaders" / "ReceiverTriangle.hlsl";
  request.stage = hlsl::Stage::vertex;
  request.entry = "ReceiverTriangle";
  return request;
}

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// The first line of any text that has the name as a word; 0: none.
int line_of_name(const std::string& text, const std::string& name) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool whole = (at == 0 || !is_name_character(text[at - 1])) &&
                       (end == text.size() || !is_name_character(text[end]));
    if (whole)
      return static_cast<int>(
                 std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')) +
             1;
  }
  return 0;
}

const MissingName kAdapterFunction{
    "ShadowVisibility",
    "an adapter defines: float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)"};

// Of the first file that was read and has the name; the user's own is read before those that it includes.
std::string place_of_name(const hlsl::SourceFiles& sources, const std::string& name) {
  for (const std::string& file : sources.names()) {
    const int line = line_of_name(sources.text(file), name);
    if (line != 0) return file + ":" + std::to_string(line);
  }
  return "";
}

std::map<std::string, std::string> named_at(const std::vector<std::uint32_t>& spirv,
                                            const hlsl::SourceFiles& sources) {
  std::map<std::string, std::string> places;
  const auto add = [&](const std::string& name) {
    const std::string place = place_of_name(sources, name);
    if (!place.empty()) places[name] = place;
  };
  add(kAdapterFunction.name);
  for (const shaders::Resource& resource : shaders::reflect(spirv).resources) {
    add(resource.name);
    for (const shaders::UniformMember& member : resource.members) {
      if (member.read) add(member.name);
    }
  }
  return places;
}

}  // namespace

ShadowShader technique_shader(const shaders::TechniqueList& list, const shaders::Technique& technique,
                              Taps taps, bool reversed_z) {
  const shaders::TechniqueCall call = shaders::emit_technique_call(list, technique, kUniformPrefix);
  ShadowShader shader;
  shader.name = technique.name;
  shader.body = "#include \"Platform/Platform.hlsl\"\n" + call.includes +
                "#include \"Core/ShadowStructs.hlsl\"\n" + call.declarations + call.function;
  shader.defines = depth_defines(reversed_z);
  for (const std::string& keyword : technique.keywords) shader.defines.emplace_back(keyword, "1");
  if (taps == Taps::unlimited) shader.defines.emplace_back("PENUMBRA_UNLIMITED", "1");
  shader.parameters = parameter_values(list, technique, taps);
  shader.uses_noise = !technique.unlimited.empty() && taps == Taps::as_listed;
  return shader;
}

ShadowShader adapter_shader(const Adapter& adapter, bool reversed_z) {
  if (!std::filesystem::is_regular_file(adapter.file)) {
    throw InputError(adapter.file.string(), "no such file", "--adapter takes the name of an HLSL file");
  }
  ShadowShader shader;
  shader.name = adapter.name;
  shader.body = "#define PENUMBRA_ADAPTER 1\n#include \"" +
                std::filesystem::absolute(adapter.file).generic_string() + "\"\n";
  shader.defines = depth_defines(reversed_z);
  for (const std::string& keyword : adapter.keywords) shader.defines.emplace_back(keyword, "1");
  shader.numbers = adapter.uniforms;
  shader.textures = adapter.textures;
  shader.package_roots = adapter.package_roots;
  shader.project = adapter.project;
  shader.cginc_root = adapter.cginc_root;
  shader.include_directories.push_back(std::filesystem::absolute(adapter.file).parent_path());
  shader.fragment = true;
  shader.prepare = true;
  shader.uses_noise = true;
  return shader;
}

CompiledShadowShader compile(const ShadowShader& shader) {
  CompiledShadowShader compiled;
  compiled.source = shader;
  shaders::CompileRequest plain = request(shader, false);
  if (shader.fragment) {
    compiled.vertex = compile_or_throw(triangle_request());
    plain.keep_unoptimised = true;
  }
  hlsl::SourceFiles sources;
  std::vector<std::uint32_t> unoptimised;
  compiled.plain = compile_or_throw(plain, &compiled.notes, &kAdapterFunction, &sources, &unoptimised);
  compiled.named_at = named_at(compiled.plain, sources);
  if (shader.fragment) check_adapter(unoptimised, shader.name, compiled.named_at);
  refuse_uncounted_fetches(request(shader, true), shader.name);
  compiled.counting = compile_or_throw(request(shader, true));
  return compiled;
}

}  // namespace penumbra::resolve
