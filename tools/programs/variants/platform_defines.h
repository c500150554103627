// The macros that Unity's importer defines before it compiles a program: per graphics API, stage and version.
//
//   SHADER_API_D3D11, _VULKAN,   1, one of them. Unity Manual, "Platform and graphics API macros"
//   _METAL, _GLCORE, _GLES3      (shader-branching-api)
//   SHADER_API_SWITCH            1. Common.hlsl of the core package takes API/Switch.hlsl for it
//   SHADER_API_MOBILE, _DESKTOP  1, one of them, none for a console. The same page: iOS, Android, tvOS;
//                                Windows, Mac, Linux, Web
//   SHADER_TARGET                45 for #pragma target 4.5. Manual, "Branch based on shader model"
//   SHADER_STAGE_VERTEX, ...     1, the stage's. Manual, SL-BuiltinMacros, "Shader stage being compiled"
//   UNITY_VERSION                202230 for 2022.3.0f1: YYYYMP, M and P up to 9 (a larger one counts as 9
//                                here); 60020003 for 6000.2.3f1: 6MMMPPPP. Manual, "Branch based on Unity
//                                version" (shader-branching-unity-version)
//   UNITY_COMPILER_HLSL          1. HLSLSupport.cginc of the built-in shaders sets it for every API here;
//                                Common.hlsl asks for it, and no package sets it
//   UNITY_COMPILER_HLSLCC        1 for Vulkan, Metal, GLCORE and GLES3, whose shaders are translated from
//                                D3D bytecode. The same source
//   SHADER_TARGET_GLSL           1 for GLCORE and GLES3. shader-branching-api: for OpenGL and GLES, always
//   UNITY_PASS_FORWARDBASE, ...  1, of the pass's LightMode: FORWARDBASE, FORWARDADD, DEFERRED, PREPASSBASE,
//                                PREPASSFINAL, SHADOWCASTER, META, MOTIONVECTORS. Unity Manual,
//                                "Built-in macros", and UnityCG.cginc of the built-in shaders
//   the settings of a platform   1, as "Platform defines:" in Unity's error messages names them: those of
//                                desktops in one of Unity 6 for d3d11, those of mobile devices in one of
//                                2021.3 for Android. They are the editor's defaults; a project may have
//                                UNITY_COLORSPACE_GAMMA and another encoding of lightmaps,
//                                UNITY_LIGHTMAP_RGBM_ENCODING among them (ProjectSettings.asset):
//                                  both     UNITY_ENABLE_REFLECTION_BUFFERS
//                                  desktop, UNITY_PBS_USE_BRDF1, UNITY_SPECCUBE_BLENDING,
//                                  console  UNITY_SPECCUBE_BOX_PROJECTION, UNITY_ENABLE_DETAIL_NORMALMAP,
//                                           UNITY_LIGHT_PROBE_PROXY_VOLUME, UNITY_LIGHTMAP_FULL_HDR,
//                                           UNITY_USE_DITHER_MASK_FOR_ALPHABLENDED_SHADOWS
//                                  mobile   UNITY_PBS_USE_BRDF2, UNITY_NO_DXT5nm, UNITY_NO_RGBM,
//                                           UNITY_NO_SCREENSPACE_SHADOWS, UNITY_LIGHTMAP_DLDR_ENCODING
//
//   _Object2World,               unity_ObjectToWorld and others: the names before Unity 5.4, which the editor
//   _LightMatrix0, ...           replaces in the file when it imports it ("Upgrade NOTE"). In CGPROGRAM
//   blocks
//                                alone
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
