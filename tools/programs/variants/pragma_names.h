// The known names in #pragma lines, for spell checking. Internal to this folder.
//
// Sources: Unity Manual, "pragma directives in HLSL" (SL-PragmaDirectives), "Targeting shader models and GPU
// features" (SL-ShaderCompileTargets), "Targeting graphics APIs and platforms" (SL-ShaderCompilationAPIs),
// "GPU instancing" (instancing_options); Microsoft's HLSL reference for pragmas of the language itself.
#pragma once

#include <optional>
#include <string_view>

#include "variants/keyword_set.h"

namespace penumbra::variants {

// A name such as multi_compile_local_fragment, parsed; suffixes may be in any order, each at most once.
struct KeywordPragmaName {
  enum class Base { multi_compile, shader_feature, dynamic_branch };
  Base base = Base::multi_compile;
  bool local = false;
  StageSet stages = StageSet::all();
};
std::optional<KeywordPragmaName> keyword_pragma_name(std::string_view name);

// Returns whether it is a known pragma that has no effect here.
bool is_option_pragma(std::string_view name);

const std::vector<std::string>& pragma_names();  // every known name, for "did you mean"
const std::vector<std::string>& renderer_names();
const std::vector<std::string>& feature_names();  // names for #pragma require
const std::vector<std::string>& instancing_option_names();

// Returns the value of SHADER_TARGET for "4.5", "es3.1", or nothing.
std::optional<int> shader_model(std::string_view name);

// The keyword sets of Unity's shortcuts: `#pragma multi_compile_fog` and similar.
//
// Source: Unity Manual, "Add built-in keyword sets" (SL-MultipleProgramVariants-shortcuts), which lists each
// shortcut's keywords and whether a variant with all of them off exists. How Unity's importer combines them
// is not documented. The sets encode what is known: a light has one type; SHADOWS_DEPTH belongs to spot,
// SHADOWS_CUBE to point and SHADOWS_SCREEN to directional lights (AutoLight.cginc of the built-in shaders);
// the editor's list for fwdbase shows LIGHTPROBE_SH, SHADOWS_SCREEN and VERTEXLIGHT_ON as independent;
// DIRLIGHTMAP_COMBINED without a lightmap has no meaning (URP strips it, too). All other combinations are
// allowed, so that no documented keyword is missed; Unity may compile fewer combinations.
//
//   _fog                  _ FOG_LINEAR FOG_EXP FOG_EXP2
//   _instancing           _ INSTANCING_ON, and PROCEDURAL_INSTANCING_ON with `instancing_options procedural`
//                         (the Manual writes PROCEDURAL_ON; the instancing libraries test the longer name)
//   _particles            _ SOFTPARTICLES_ON
//   _shadowcaster         SHADOWS_DEPTH SHADOWS_CUBE
//   _shadowcollector      nothing: passes of that type are no longer drawn
//   _fwdadd               POINT DIRECTIONAL SPOT POINT_COOKIE DIRECTIONAL_COOKIE
//   _fwdadd_fullshadows,  those, each with and without its shadows, point and spot also with SHADOWS_SOFT;
//   _lightpass            LIGHTMAP_SHADOW_MIXING and SHADOWS_SHADOWMASK free
//   _fwdbase              DIRECTIONAL; free: LIGHTMAP_ON DIRLIGHTMAP_COMBINED DYNAMICLIGHTMAP_ON
//                         LIGHTMAP_SHADOW_MIXING SHADOWS_SHADOWMASK SHADOWS_SCREEN LIGHTPROBE_SH
//                         VERTEXLIGHT_ON
//   _fwdbasealpha         DIRECTIONAL; free: the lightmaps as above, LIGHTMAP_SHADOW_MIXING LIGHTPROBE_SH
//                         VERTEXLIGHT_ON
//   _prepassfinal         free: the lightmaps as above, UNITY_HDR_ON SHADOWS_SHADOWMASK LIGHTPROBE_SH
struct BuiltInSets {
  std::vector<std::vector<Keywords>> sets;  // each set's alternatives
  std::vector<Clause> clauses;
};

// Returns the sets of "multi_compile_fog" and so on; nothing for other names.
std::optional<BuiltInSets> built_in_sets(std::string_view pragma);

std::vector<std::string> built_in_set_names();

// Returns the keywords that Unity adds to every graphics program and strips where XR is off (Unity Manual,
// "Default shader keywords"): _, STEREO_INSTANCING_ON, STEREO_MULTIVIEW_ON, UNITY_SINGLE_PASS_STEREO, of
// which `modes` selects some. STEREO_CUBEMAP_RENDER_ON is for capturing panoramas in the editor and not
// included.
KeywordSet stereo_set(const Keywords& modes);

}  // namespace penumbra::variants
