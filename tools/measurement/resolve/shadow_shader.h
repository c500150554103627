// The HLSL of one way to answer "how much of the light does this receiver see": a technique of
// the manifests, or a function of the user's own.
//
// The generated text includes, in this order: the platform macros and the technique's file, or the user's
// file, which brings its own; then shaders/Resolve.hlsl, whose Main runs once per receiver.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "parameters/cascades.h"
#include "platform/worker_pool.h"
#include "resolve/adapter_resources.h"
#include "resolve/module_order.h"
#include "resolve/uniform_values.h"
#include "shaders/compile.h"
#include "shaders/reflect.h"
#include "techniques/technique_list.h"

namespace penumbra::resolve {

// The numbers by the name of a uniform ("_Taps"), an element ("_Taps[3]") or a field ("_Settings.radius",
// "_Lights[1].colour"). They fill it in the order of its declaration, a matrix row by row as mul(M, v) reads
// it.
using UniformNumbers = std::map<std::string, std::vector<double>>;

// Throws InputError for a name that none of the blocks has (with the nearest one and those that are read),
// for too few or too many numbers, and for an int uniform whose number is no integer. The message names the
// uniform's place, or else `shader`.
void check_numbers(const UniformNumbers& numbers, const std::vector<shaders::Resource>& resources,
                   const std::string& shader, const std::map<std::string, std::string>& places = {});

// Writes those of the numbers that belong to this block.
void write_numbers(const UniformNumbers& numbers, const shaders::Resource& block,
                   std::vector<std::byte>& bytes);

// Returns whether any of the numbers belongs to this uniform or a part of it.
bool has_numbers(const UniformNumbers& numbers, const std::string& uniform);

// The uniforms of a technique's parameters, packed as the shaders unpack them
// (techniques/parameter_packing.h).
enum class Taps { as_listed, unlimited };  // unlimited: the technique's own T3 overrides

UniformValues parameter_uniforms(const techniques::TechniqueList& list,
                                 const techniques::Technique& technique, Taps taps = Taps::as_listed);

struct ShadowShader {
  std::string name;
  std::filesystem::path file{};         // a user's file; empty for a technique
  std::filesystem::path written_for{};  // the file whose function is called, a user's or a technique's
  std::string body;                     // the text before Resolve.hlsl, its platform macros included
  std::vector<std::pair<std::string, std::string>> defines;
  std::vector<shaders::PackageRoot> package_roots;
  std::vector<std::filesystem::path> include_directories;
  std::filesystem::path project;     // "#include "Assets/..." resolves under it; may be empty
  std::filesystem::path cginc_root;  // the editor's CGIncludes; may be empty
  UniformValues parameters;
  UniformNumbers numbers{};                // a user's, for uniforms of any type
  std::vector<AdapterTexture> textures{};  // a user's, under the names by which the shader reads them
  // If true, it runs as a fragment shader over the picture, as a user's function did in its engine; otherwise
  // as a compute shader.
  bool fragment = false;
  bool prepare = false;     // rewrites code that only Unity's compilers accept
  bool uses_noise = false;  // the result depends on the noise seed
};

ShadowShader technique_shader(const techniques::TechniqueList& list, const techniques::Technique& technique,
                              Taps taps = Taps::as_listed, bool reversed_z = true,
                              techniques::LightKind light = techniques::LightKind::directional);

// A user's own function, in `file`:
//   float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)
// It runs in a fragment shader over the picture, so derivatives are those between pixels. It includes the
// texture macros it uses, "Platform/Platform.hlsl" or its pipeline's, and may read, by name, URP's main light
// shadow globals and the harness's own (docs/measuring.md). Its casters are drawn at
// `bias`.
struct Adapter {
  std::string name;
  std::filesystem::path file;
  std::vector<std::string> keywords;  // defined as 1
  UniformNumbers uniforms;            // these replace the frame's
  std::vector<AdapterTexture> textures;
  parameters::CasterBias bias{};  // URP's own default
  double light_scale = 1.0;       // the diameter that the function gets, divided by the light's
  std::vector<shaders::PackageRoot> package_roots;
  std::filesystem::path project;     // a Unity project whose Assets/ it includes; may be empty
  std::filesystem::path cginc_root;  // the editor's CGIncludes; may be empty
};
ShadowShader adapter_shader(const Adapter& adapter, bool reversed_z = true);

// The order compiles a compute shader with the entry point Main, or for a user's function the fragment shader
// ResolveFragment over a triangle.
ModuleOrder module_order(const ShadowShader& shader);

}  // namespace penumbra::resolve
