// The settings of the Universal Render Pipeline that decide which shader variants a build keeps.
//
// Mirrors, for one quality level and one renderer, what URP's editor code strips: ShaderPreprocessor.cs
// (URP 10 to 13) and ShaderScriptableStripper.cs with ShaderBuildPreprocessor.cs (from 14). A setting that is
// absent decides nothing. "never K": no variant has the keyword. "always K": variants without it go, too,
// which URP does where "Strip Unused Variants" is on (the default) and it asks StripMultiCompile; where it
// asks StripMultiCompileKeepOffVariant, true decides nothing.
//
// true or false in JSON              false                                  true
//   main_light_shadows               never _MAIN_LIGHT_SHADOWS, _CASCADE
//   screen_space_shadows             never _MAIN_LIGHT_SHADOWS_SCREEN
//   additional_light_shadows         never _ADDITIONAL_LIGHT_SHADOWS,
//                                    _CASTING_PUNCTUAL_LIGHT_SHADOW
//   soft_shadows                     never _SHADOWS_SOFT, _LOW, _MEDIUM, _HIGH
//   light_layers                     never _LIGHT_LAYERS                    always
//   light_cookies                    never _LIGHT_COOKIES
//   reflection_probe_blending        never _REFLECTION_PROBE_BLENDING       always
//   reflection_probe_box_projection  never _REFLECTION_PROBE_BOX_PROJECTION always
//   mixed_lighting                   never LIGHTMAP_SHADOW_MIXING, SHADOWS_SHADOWMASK,
//                                    _MIXED_LIGHTING_SUBTRACTIVE
//   lightmaps                        never LIGHTMAP_ON
//   directional_lightmaps            never DIRLIGHTMAP_COMBINED
//   realtime_lightmaps               never DYNAMICLIGHTMAP_ON
//   accurate_gbuffer_normals         never _GBUFFER_NORMALS_OCT             always
//   render_pass                      never _RENDER_PASS_ENABLED             (URP up to 13: always)
//   decal_layers                     never _DECAL_LAYERS                    always
//   write_rendering_layers           never _WRITE_RENDERING_LAYERS
//   fast_srgb_conversion             never _USE_FAST_SRGB_LINEAR_CONVERSION always
//   lod_cross_fade                   never LOD_FADE_CROSSFADE
//   debug_display                    never DEBUG_DISPLAY
//   gpu_instancing                   never INSTANCING_ON, PROCEDURAL_INSTANCING_ON
//   dots_instancing                  never DOTS_INSTANCING_ON
//   depth_normals                    passes only: see unused_passes()
//
// one of several values
//   shadow_cascades     1: never _MAIN_LIGHT_SHADOWS_CASCADE; 2 to 4: never _MAIN_LIGHT_SHADOWS. Narrower
//                       than URP, which keeps both because scripts may change the count
//   additional_lights   "disabled": never _ADDITIONAL_LIGHTS, _ADDITIONAL_LIGHTS_VERTEX;
//                       "per_vertex", "per_pixel": never the other one
//   rendering_mode      "forward", "deferred": never _FORWARD_PLUS, which is _CLUSTERED_RENDERING up to
//                       URP 13 and _CLUSTER_LIGHT_LOOP from 17.1; "forward_plus": always that one, and never
//                       the keywords of additional_lights, which Forward+ defines itself
//   decals              "none", "screen_space", "gbuffer": never _DBUFFER_MRT1, 2, 3; "dbuffer_albedo",
//                       "dbuffer_albedo_normal", "dbuffer_albedo_normal_maos": always 1, 2 or 3, no other
//   decal_normal_blend  "low", "medium", "high": always that _DECAL_NORMAL_BLEND_*; "none": never
//   ssao                "off": never _SCREEN_SPACE_OCCLUSION; "on": always; "after_opaque": either
//
// lists
//   fog  of linear, exp, exp2: never the FOG_* that is not listed
//   xr   of instancing, multiview, single_pass: the stereo keywords, as one more set; none without it. On
//   OpenGL
//        ES never instancing, which multiview replaces there (on_api() in keyword_space.h)
//
// Lightmap, fog and instancing keywords are stripped by Unity itself, from the scenes and Project Settings >
// Graphics (Unity Manual, "Shader variant stripping"), not by URP. Whatever the settings, URP strips:
//   _SHADOWS_SOFT* without any shadow, _ADDITIONAL_LIGHT_SHADOWS without _ADDITIONAL_LIGHTS or Forward+
//   (unless deferred), DIRLIGHTMAP_COMBINED without a lightmap, EDITOR_VISUALIZATION.
// Variants without shadows or additional lights are kept, as URP does unless its renderer says otherwise.
// Not mirrored: rules that name one shader (post-processing, terrain holes, HDR output, lens flares),
// _WRITE_RENDERING_LAYERS by pass name, EVALUATE_SH_*, _FOVEATED_RENDERING_*: use "keywords" for those.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "variants/keyword_set.h"

namespace penumbra::variants {

enum class AdditionalLights { disabled, per_vertex, per_pixel };
enum class RenderingMode { forward, deferred, forward_plus };
enum class Decals {
  none,
  dbuffer_albedo,
  dbuffer_albedo_normal,
  dbuffer_albedo_normal_maos,
  screen_space,
  gbuffer
};
enum class NormalBlend { none, low, medium, high };
enum class AmbientOcclusion { off, on, after_opaque };
enum class Fog { linear, exp, exp2 };

struct UrpSettings {
  std::optional<bool> main_light_shadows;
  std::optional<bool> screen_space_shadows;
  std::optional<int> shadow_cascades;
  std::optional<AdditionalLights> additional_lights;
  std::optional<bool> additional_light_shadows;
  std::optional<bool> soft_shadows;
  std::optional<bool> light_layers;
  std::optional<bool> light_cookies;
  std::optional<bool> reflection_probe_blending;
  std::optional<bool> reflection_probe_box_projection;
  std::optional<bool> mixed_lighting;
  std::optional<bool> lightmaps;
  std::optional<bool> directional_lightmaps;
  std::optional<bool> realtime_lightmaps;
  std::optional<std::vector<Fog>> fog;
  std::optional<RenderingMode> rendering_mode;
  std::optional<bool> accurate_gbuffer_normals;
  std::optional<bool> render_pass;
  std::optional<Decals> decals;
  std::optional<NormalBlend> decal_normal_blend;
  std::optional<bool> decal_layers;
  std::optional<AmbientOcclusion> ssao;
  std::optional<bool> write_rendering_layers;
  std::optional<bool> fast_srgb_conversion;
  std::optional<bool> lod_cross_fade;
  std::optional<bool> debug_display;
  std::optional<bool> gpu_instancing;
  std::optional<bool> dots_instancing;
  std::optional<bool> depth_normals;
  Keywords xr;  // the stereo keywords of stereo_set()
};

// A setting that is true or false: its names, and the keywords that no variant has where it is false.
struct UrpSwitch {
  std::optional<bool> UrpSettings::*setting;
  const char* name;        // the key in JSON
  std::string_view field;  // the field of URP's assets that holds it; empty if none does
  Keywords keywords;
  bool always_when_on = false;  // all variants have the keywords where it is true
};
const std::vector<UrpSwitch>& urp_switches();

// said_by is the origin that messages name: the file.
std::vector<Clause> clauses_of(const UrpSettings& settings, const std::string& said_by);

// Passes (by name or LightMode tag) that URP strips whole: GBuffer unless deferred, ShadowCaster without any
// shadows, DepthNormals where nothing reads them, and the decal passes that the decals setting does not use.
std::vector<std::string> unused_passes(const UrpSettings& settings);

// A value only where both agree: for projects with several quality levels or renderers, each of which needs
// its variants.
UrpSettings widest(const UrpSettings& a, const UrpSettings& b);

// The settings of either, b where both have one: an asset and the renderer it uses.
UrpSettings combined(const UrpSettings& a, const UrpSettings& b);

// Reads the settings from a text-serialised .asset of URP: a UniversalRenderPipelineAsset or a
// UniversalRendererData (rendering mode, G-buffer normals). Lines `  m_Name: value` of known names count, all
// others are ignored; shadow_cascades is not set, as in URP. Throws InputError for a value that is out of
// range, a binary asset, and a file without any known name.
UrpSettings read_urp_asset(std::string_view text, const std::string& name);

// The settings of a project with such files: all quality levels' pipeline assets (the widest of them)
// together with all renderers (the widest). Throws InputError as read_urp_asset does, and for files that
// cannot be read.
UrpSettings read_urp_assets(const std::vector<std::filesystem::path>& files);

}  // namespace penumbra::variants
