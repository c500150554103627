#include "resolve/shadow_shader.h"

#include <fmt/format.h>
#include <glm/vec4.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "input/input_error.h"
#include "input/nearest_name.h"
#include "platform/data_directory.h"
#include "project/include_bounds.h"
#include "techniques/parameter_packing.h"
#include "techniques/technique_call.h"

namespace penumbra::resolve {
namespace {

using shaders::ScalarKind;
using shaders::UniformLeaf;

// Returns whether `path` is `name` or a part of it: "_Lights[1].colour" is a part of "_Lights", and
// "_LightsOn" is not.
bool is_of(const std::string& path, const std::string& name) {
  if (path.compare(0, name.size(), name) != 0) return false;
  return path.size() == name.size() || path[name.size()] == '.' || path[name.size()] == '[';
}

std::vector<const UniformLeaf*> leaves_of(const shaders::Resource& block, const std::string& name) {
  std::vector<const UniformLeaf*> leaves;
  for (const shaders::UniformMember& member : block.members) {
    for (const UniformLeaf& leaf : member.leaves) {
      if (is_of(leaf.path, name)) leaves.push_back(&leaf);
    }
  }
  return leaves;
}

std::size_t count_of(const UniformLeaf& leaf) {
  return static_cast<std::size_t>(leaf.rows) * leaf.columns;
}

bool fits(ScalarKind kind, double number) {
  if (kind == ScalarKind::float32) return true;
  const double low = kind == ScalarKind::int32 ? std::numeric_limits<std::int32_t>::min() : 0.0;
  const double high = kind == ScalarKind::int32 ? std::numeric_limits<std::int32_t>::max()
                                                : std::numeric_limits<std::uint32_t>::max();
  return kind != ScalarKind::other && std::trunc(number) == number && number >= low && number <= high;
}

std::uint32_t word(ScalarKind kind, double number) {
  switch (kind) {
    case ScalarKind::int32:
      return std::bit_cast<std::uint32_t>(static_cast<std::int32_t>(number));
    case ScalarKind::uint32:
      return static_cast<std::uint32_t>(number);
    default:
      return std::bit_cast<std::uint32_t>(static_cast<float>(number));
  }
}

// Returns the offset of the n-th number of a leaf. glslang decorates HLSL's column_major matrices RowMajor,
// with rows and columns exchanged: in memory such a matrix holds the columns of mul(M, v).
std::size_t offset_of(const UniformLeaf& leaf, std::size_t n) {
  if (leaf.columns == 1) return leaf.offset + 4 * n;
  // SPIR-V's matrix is the transpose of HLSL's: its columns are HLSL's rows.
  const std::size_t row = n / leaf.rows;
  const std::size_t column = n % leaf.rows;
  return leaf.row_major ? leaf.offset + column * leaf.matrix_stride + 4 * row
                        : leaf.offset + row * leaf.matrix_stride + 4 * column;
}

// Returns "_Lights" for "_Lights[1].colour".
std::string uniform_of(const std::string& path) {
  return path.substr(0, path.find_first_of(".["));
}

struct KnownNames {
  std::vector<std::string> all;    // names of uniforms
  std::vector<std::string> read;   // those of them that the shader reads
  std::vector<std::string> parts;  // elements and fields of the requested uniform
};

KnownNames known_names(const std::vector<shaders::Resource>& resources, const std::string& asked) {
  KnownNames names;
  for (const shaders::Resource& resource : resources) {
    for (const shaders::UniformMember& member : resource.members) {
      names.all.push_back(member.name);
      if (member.read) names.read.push_back(member.name);
      if (member.name != uniform_of(asked)) continue;
      for (const UniformLeaf& leaf : member.leaves) names.parts.push_back(leaf.path);
    }
  }
  return names;
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 24;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i) text += (i == 0 ? "" : ", ") + names[i];
  return names.size() > most ? text + ", ..." : text;
}

// Names what exists instead: the parts of a uniform that is there, or else the uniforms.
std::string remedy_of(const std::string& name, const KnownNames& known) {
  const bool is_part = !known.parts.empty();
  const std::string nearest = nearest_name(name, is_part ? known.parts : known.all);
  const std::string meant = nearest.empty() ? "" : "did you mean '" + nearest + "'? ";
  if (is_part) return meant + "'" + uniform_of(name) + "' has " + listed(known.parts);
  return meant + "it reads " + (known.read.empty() ? "no uniform" : listed(known.read));
}

const std::string& place_of(const std::string& name, const std::map<std::string, std::string>& places,
                            const std::string& shader) {
  const auto found = places.find(uniform_of(name));
  return found == places.end() ? shader : found->second;
}

void check(const std::string& name, const std::vector<double>& numbers,
           const std::vector<const UniformLeaf*>& leaves, const std::string& shader) {
  std::size_t wanted = 0;
  for (const UniformLeaf* leaf : leaves) {
    for (std::size_t i = 0; i < count_of(*leaf) && wanted < numbers.size(); ++i, ++wanted) {
      if (fits(leaf->scalar, numbers[wanted])) continue;
      throw InputError(shader, fmt::format("uniform '{}' is declared as an integer and cannot be {}",
                                           leaf->path, numbers[wanted]));
    }
  }
  wanted = 0;
  for (const UniformLeaf* leaf : leaves) wanted += count_of(*leaf);
  if (wanted == numbers.size()) return;
  throw InputError(shader, fmt::format("uniform '{}' is declared with {} number{} and is given {}", name,
                                       wanted, wanted == 1 ? "" : "s", numbers.size()));
}

using Values = std::map<std::string, std::vector<double>>;

Values with_taps(Values values, const std::map<std::string, double>& unlimited, Taps taps) {
  if (taps == Taps::unlimited)
    for (const auto& [field, number] : unlimited) values[field] = {number};
  return values;
}

template <typename Name>
void set_packed(UniformValues& uniforms, const techniques::ParameterStruct& parameters, const Values& values,
                Name name) {
  const std::vector<std::array<float, 4>> vectors = techniques::packed(parameters, values);
  for (std::size_t i = 0; i < vectors.size(); ++i)
    uniforms.set(name(i), glm::vec4(vectors[i][0], vectors[i][1], vectors[i][2], vectors[i][3]));
}

std::vector<std::pair<std::string, std::string>> depth_defines(bool reversed_z) {
  if (reversed_z) return {{"UNITY_REVERSED_Z", "1"}};
  return {};
}

// The platform macros come with the body, so that an adapter may bring its pipeline's instead; where it
// brings none, the harness still has to have some.
std::string whole_source(const ShadowShader& shader) {
  return shader.body + "#include \"Platform/Platform.hlsl\"\n#include \"Resolve.hlsl\"\n";
}

// The roots contain this library under the name it has in Unity, unless the user brings a version of it.
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

void check_numbers(const UniformNumbers& numbers, const std::vector<shaders::Resource>& resources,
                   const std::string& shader, const std::map<std::string, std::string>& places) {
  for (const auto& [name, values] : numbers) {
    const std::string& where = place_of(name, places, shader);
    bool found = false;
    for (const shaders::Resource& resource : resources) {
      const std::vector<const UniformLeaf*> leaves = leaves_of(resource, name);
      if (leaves.empty()) continue;
      found = true;
      check(name, values, leaves, where);
    }
    if (found) continue;
    throw InputError(where, fmt::format("the shader reads no uniform '{}'", name),
                     remedy_of(name, known_names(resources, name)));
  }
}

void write_numbers(const UniformNumbers& numbers, const shaders::Resource& block,
                   std::vector<std::byte>& bytes) {
  for (const auto& [name, values] : numbers) {
    auto next = values.begin();
    for (const UniformLeaf* leaf : leaves_of(block, name)) {
      for (std::size_t n = 0; n < count_of(*leaf) && next != values.end(); ++n, ++next) {
        const std::uint32_t bits = word(leaf->scalar, *next);
        const std::size_t at = offset_of(*leaf, n);
        if (at + sizeof(bits) <= bytes.size()) std::memcpy(bytes.data() + at, &bits, sizeof(bits));
      }
    }
  }
}

bool has_numbers(const UniformNumbers& numbers, const std::string& uniform) {
  for (const auto& entry : numbers) {
    if (is_of(entry.first, uniform)) return true;
  }
  return false;
}

UniformValues parameter_uniforms(const techniques::TechniqueList& list,
                                 const techniques::Technique& technique, Taps taps) {
  const Values values = with_taps(technique.values, technique.unlimited, taps);
  UniformValues uniforms;
  for (const techniques::ParameterStruct* parameters : list.structs_of(technique))
    set_packed(uniforms, *parameters, values,
               [&](std::size_t i) { return techniques::uniform_name(*parameters, i); });
  for (const techniques::CascadeRule& rule : techniques::compiled_rules(list, technique)) {
    Values of_rule = techniques::values_of(rule, technique);
    if (const techniques::ParameterStruct* parameters = list.find_struct(rule.filter.parameters))
      set_packed(uniforms, *parameters, with_taps(std::move(of_rule), rule.unlimited, taps),
                 [&](std::size_t i) { return techniques::uniform_name(*parameters, i, rule); });
  }
  return uniforms;
}

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
