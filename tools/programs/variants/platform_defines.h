// The macros that Unity's importer defines before it compiles a program: per graphics API, stage and version.
// The table of names, with Unity's source for each and the versions that define it, is in docs/validating.md,
// "Names that Unity defines".
//
// Deliberately absent, because a library defines them from the macros above and would define them twice:
//   - from the core package, API/D3D11.hlsl, Vulkan.hlsl, Metal.hlsl, Switch.hlsl, GLCore.hlsl, GLES3.hlsl:
//     UNITY_UV_STARTS_AT_TOP, UNITY_REVERSED_Z (first four), UNITY_NEAR_CLIP_VALUE,
//     UNITY_RAW_FAR_CLIP_VALUE, CBUFFER_START, TEXTURE2D and similar, PLATFORM_SUPPORTS_*, UNITY_BRANCH, ...;
//   - from UnityInstancing.hlsl (core) or UnityInstancing.cginc: UNITY_INSTANCING_ENABLED of INSTANCING_ON,
//     UNITY_PROCEDURAL_INSTANCING_ENABLED of PROCEDURAL_INSTANCING_ON, UNITY_DOTS_INSTANCING_ENABLED of
//     DOTS_INSTANCING_ON, UNITY_STEREO_INSTANCING_ENABLED of STEREO_INSTANCING_ON;
//   - from HLSLSupport.cginc, which CGPROGRAM blocks include unasked and HLSLPROGRAM blocks do not:
//     UNITY_STEREO_MULTIVIEW_ENABLED of STEREO_MULTIVIEW_ON, and its own UNITY_COMPILER_*,
//     UNITY_REVERSED_Z, UNITY_UV_STARTS_AT_TOP, CBUFFER_START, ...
// The keywords from which these are derived are defined by their variant (pragma_names.h), like every
// keyword; UNITY_SINGLE_PASS_STEREO is one that the libraries test directly.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "hlsl/stage.h"

namespace penumbra::variants {

enum class GraphicsApi { d3d11, vulkan, metal, glcore, gles3, nintendo_switch };

inline constexpr GraphicsApi all_graphics_apis[] = {GraphicsApi::d3d11, GraphicsApi::vulkan,
                                                    GraphicsApi::metal, GraphicsApi::glcore,
                                                    GraphicsApi::gles3, GraphicsApi::nintendo_switch};

// Returns the name in #pragma only_renderers: d3d11, vulkan, metal, glcore, gles3, switch.
const char* renderer_name(GraphicsApi api);
std::optional<GraphicsApi> find_graphics_api(std::string_view renderer);

// Returns whether a stage-specific keyword (multi_compile_fragment and others) is defined in its stage alone.
// For OpenGL and Vulkan the editor defines it in all stages (Unity Manual, "Declaring and using shader
// keywords").
bool keeps_stage_keywords(GraphicsApi api);

// In the order of ProjectSettings.asset: low, normal and high quality.
enum class LightmapEncoding { dldr, rgbm, full_hdr };

struct Platform {
  GraphicsApi api = GraphicsApi::vulkan;
  bool mobile = false;
  int unity_version = 202230;
  // For CGPROGRAM, HLSLSupport.cginc is included first and detects the compiler itself.
  bool includes_hlsl_support = false;
  std::string light_mode{};                     // value of the pass's tag LightMode; empty without one
  bool gamma = false;                           // colour space gamma
  std::optional<LightmapEncoding> lightmaps{};  // the platform's default if absent
};

// Returns UNITY_VERSION of "2022.3.21f1" (202239), "6000.0.23f1" (60000023) or, for its first patch,
// "2022.3"; nothing if the text is not a version.
std::optional<int> unity_version_number(std::string_view version);

// Returns the macros for conditions around #pragma lines: the platform's constants, without stage, target and
// compiler.
std::map<std::string, std::string> pragma_defines(const Platform& platform);

// Returns everything in the table, for one stage at one shader target.
std::map<std::string, std::string> platform_defines(const Platform& platform, hlsl::Stage stage,
                                                    int shader_target);

}  // namespace penumbra::variants
