#include "variants/urp_settings.h"

#include <algorithm>
#include <utility>

namespace penumbra::variants {
namespace {

const Keywords forward_plus_keywords{"_FORWARD_PLUS", "_CLUSTERED_RENDERING", "_CLUSTER_LIGHT_LOOP"};
const Keywords soft_keywords{"_SHADOWS_SOFT", "_SHADOWS_SOFT_LOW", "_SHADOWS_SOFT_MEDIUM",
                             "_SHADOWS_SOFT_HIGH"};

}  // namespace

const std::vector<UrpSwitch>& urp_switches() {
  static const std::vector<UrpSwitch> all{
      {&UrpSettings::main_light_shadows,
       "main_light_shadows",
       "m_MainLightShadowsSupported",
       {"_MAIN_LIGHT_SHADOWS", "_MAIN_LIGHT_SHADOWS_CASCADE"}},
      {&UrpSettings::screen_space_shadows, "screen_space_shadows", "", {"_MAIN_LIGHT_SHADOWS_SCREEN"}},
      {&UrpSettings::additional_light_shadows,
       "additional_light_shadows",
       "m_AdditionalLightShadowsSupported",
       {"_ADDITIONAL_LIGHT_SHADOWS", "_CASTING_PUNCTUAL_LIGHT_SHADOW"}},
      {&UrpSettings::soft_shadows, "soft_shadows", "m_SoftShadowsSupported", soft_keywords},
      {&UrpSettings::light_layers, "light_layers", "m_SupportsLightLayers", {"_LIGHT_LAYERS"}, true},
      {&UrpSettings::light_cookies, "light_cookies", "m_SupportsLightCookies", {"_LIGHT_COOKIES"}},
      {&UrpSettings::reflection_probe_blending,
       "reflection_probe_blending",
       "m_ReflectionProbeBlending",
       {"_REFLECTION_PROBE_BLENDING"},
       true},
      {&UrpSettings::reflection_probe_box_projection,
       "reflection_probe_box_projection",
       "m_ReflectionProbeBoxProjection",
       {"_REFLECTION_PROBE_BOX_PROJECTION"},
       true},
      {&UrpSettings::mixed_lighting,
       "mixed_lighting",
       "m_MixedLightingSupported",
       {"LIGHTMAP_SHADOW_MIXING", "SHADOWS_SHADOWMASK", "_MIXED_LIGHTING_SUBTRACTIVE"}},
      {&UrpSettings::lightmaps, "lightmaps", "", {"LIGHTMAP_ON"}},
      {&UrpSettings::directional_lightmaps, "directional_lightmaps", "", {"DIRLIGHTMAP_COMBINED"}},
      {&UrpSettings::realtime_lightmaps, "realtime_lightmaps", "", {"DYNAMICLIGHTMAP_ON"}},
      {&UrpSettings::accurate_gbuffer_normals,
       "accurate_gbuffer_normals",
       "m_AccurateGbufferNormals",
       {"_GBUFFER_NORMALS_OCT"},
       true},
      {&UrpSettings::render_pass, "render_pass", "", {"_RENDER_PASS_ENABLED"}},
      {&UrpSettings::decal_layers, "decal_layers", "", {"_DECAL_LAYERS"}, true},
      {&UrpSettings::write_rendering_layers, "write_rendering_layers", "", {"_WRITE_RENDERING_LAYERS"}},
      {&UrpSettings::fast_srgb_conversion,
       "fast_srgb_conversion",
       "m_UseFastSRGBLinearConversion",
       {"_USE_FAST_SRGB_LINEAR_CONVERSION"},
       true},
      {&UrpSettings::lod_cross_fade, "lod_cross_fade", "m_EnableLODCrossFade", {"LOD_FADE_CROSSFADE"}},
      {&UrpSettings::debug_display, "debug_display", "", {"DEBUG_DISPLAY"}},
      {&UrpSettings::gpu_instancing, "gpu_instancing", "", {"INSTANCING_ON", "PROCEDURAL_INSTANCING_ON"}},
      {&UrpSettings::dots_instancing, "dots_instancing", "", {"DOTS_INSTANCING_ON"}},
      {&UrpSettings::depth_normals, "depth_normals", "", {}},
  };
  return all;
}

namespace {

class Clauses {
 public:
  explicit Clauses(std::string said_by) : said_by_(std::move(said_by)) {}

  void forbid(const Keywords& keywords) {
    for (const std::string& keyword : keywords) list.push_back(never(keyword, said_by_));
  }
  void demand(const std::string& keyword) { list.push_back(always(keyword, said_by_)); }
  void tie(const std::string& keyword, const Keywords& any_of) {
    list.push_back(needs(keyword, any_of, said_by_));
  }
  // The keyword at `chosen` is on (none when it is out of range), and the others never.
  void choose(const Keywords& keywords, int chosen) {
    for (std::size_t i = 0; i < keywords.size(); ++i) {
      if (static_cast<int>(i) == chosen) {
        demand(keywords[i]);
      } else {
        forbid({keywords[i]});
      }
    }
  }

  std::vector<Clause> list;

 private:
  std::string said_by_;
};

void add_lights(const UrpSettings& settings, Clauses& clauses) {
  const bool forward_plus = settings.rendering_mode == RenderingMode::forward_plus;
  if (forward_plus) {
    for (const std::string& keyword : forward_plus_keywords) clauses.demand(keyword);
  } else if (settings.rendering_mode) {
    clauses.forbid(forward_plus_keywords);
  }
  const auto lights = settings.additional_lights;
  if (forward_plus || lights == AdditionalLights::disabled || lights == AdditionalLights::per_pixel)
    clauses.forbid({"_ADDITIONAL_LIGHTS_VERTEX"});
  if (forward_plus || lights == AdditionalLights::disabled || lights == AdditionalLights::per_vertex)
    clauses.forbid({"_ADDITIONAL_LIGHTS"});
}

void add_shadows(const UrpSettings& settings, Clauses& clauses) {
  if (settings.shadow_cascades)
    clauses.forbid({*settings.shadow_cascades > 1 ? "_MAIN_LIGHT_SHADOWS" : "_MAIN_LIGHT_SHADOWS_CASCADE"});
  for (const std::string& soft : soft_keywords)
    clauses.tie(soft, {"_MAIN_LIGHT_SHADOWS", "_MAIN_LIGHT_SHADOWS_CASCADE", "_MAIN_LIGHT_SHADOWS_SCREEN",
                       "_ADDITIONAL_LIGHT_SHADOWS"});
  if (settings.rendering_mode == RenderingMode::deferred) return;
  Keywords lights = forward_plus_keywords;
  lights.insert(lights.end(), {"_ADDITIONAL_LIGHTS", "_DEFERRED_STENCIL"});
  clauses.tie("_ADDITIONAL_LIGHT_SHADOWS", lights);
}

void add_screen_effects(const UrpSettings& settings, Clauses& clauses) {
  if (settings.decals) {
    const int buffers = static_cast<int>(*settings.decals) - static_cast<int>(Decals::dbuffer_albedo);
    clauses.choose({"_DBUFFER_MRT1", "_DBUFFER_MRT2", "_DBUFFER_MRT3"}, buffers);
  }
  if (settings.decal_normal_blend) {
    const int blend = static_cast<int>(*settings.decal_normal_blend) - static_cast<int>(NormalBlend::low);
    clauses.choose({"_DECAL_NORMAL_BLEND_LOW", "_DECAL_NORMAL_BLEND_MEDIUM", "_DECAL_NORMAL_BLEND_HIGH"},
                   blend);
  }
  if (settings.ssao == AmbientOcclusion::off) clauses.forbid({"_SCREEN_SPACE_OCCLUSION"});
  if (settings.ssao == AmbientOcclusion::on) clauses.demand("_SCREEN_SPACE_OCCLUSION");
  if (settings.fog) {
    const Keywords keywords{"FOG_LINEAR", "FOG_EXP", "FOG_EXP2"};
    for (const Fog fog : {Fog::linear, Fog::exp, Fog::exp2}) {
      const bool used = std::find(settings.fog->begin(), settings.fog->end(), fog) != settings.fog->end();
      if (!used) clauses.forbid({keywords[static_cast<std::size_t>(fog)]});
    }
  }
}

// Calls visit(result, other) for every setting that may be absent.
template <typename Visit>
void for_each_setting(UrpSettings& result, const UrpSettings& other, Visit visit) {
  for (const UrpSwitch& known : urp_switches()) visit(result.*known.setting, other.*known.setting);
  visit(result.shadow_cascades, other.shadow_cascades);
  visit(result.additional_lights, other.additional_lights);
  visit(result.fog, other.fog);
  visit(result.rendering_mode, other.rendering_mode);
  visit(result.decals, other.decals);
  visit(result.decal_normal_blend, other.decal_normal_blend);
  visit(result.ssao, other.ssao);
  for (const std::string& mode : other.xr)
    if (!contains(result.xr, mode)) result.xr.push_back(mode);
}

}  // namespace

std::vector<Clause> clauses_of(const UrpSettings& settings, const std::string& said_by) {
  Clauses clauses(said_by);
  for (const UrpSwitch& known : urp_switches()) {
    const std::optional<bool> on = settings.*known.setting;
    if (on == false) clauses.forbid(known.keywords);
    if (on == true && known.always_when_on)
      for (const std::string& keyword : known.keywords) clauses.demand(keyword);
  }
  add_lights(settings, clauses);
  add_shadows(settings, clauses);
  add_screen_effects(settings, clauses);
  clauses.tie("DIRLIGHTMAP_COMBINED", {"LIGHTMAP_ON", "DYNAMICLIGHTMAP_ON"});
  clauses.forbid({"EDITOR_VISUALIZATION"});
  return std::move(clauses.list);
}

std::vector<std::string> unused_passes(const UrpSettings& settings) {
  std::vector<std::string> passes;
  const auto add = [&](bool unused, std::initializer_list<const char*> names) {
    if (unused) passes.insert(passes.end(), names.begin(), names.end());
  };
  const auto mode = settings.rendering_mode;
  add(mode && *mode != RenderingMode::deferred, {"GBuffer", "UniversalGBuffer"});
  add(settings.main_light_shadows == false && settings.additional_light_shadows == false, {"ShadowCaster"});
  add(settings.depth_normals == false, {"DepthNormals", "DepthNormalsOnly"});
  if (!settings.decals) return passes;
  const Decals decals = *settings.decals;
  const bool buffers = decals == Decals::dbuffer_albedo || decals == Decals::dbuffer_albedo_normal ||
                       decals == Decals::dbuffer_albedo_normal_maos;
  add(!buffers,
      {"DBufferMesh", "DBufferProjector", "DecalMeshForwardEmissive", "DecalProjectorForwardEmissive"});
  add(decals != Decals::screen_space, {"DecalScreenSpaceMesh", "DecalScreenSpaceProjector"});
  add(decals != Decals::gbuffer, {"DecalGBufferMesh", "DecalGBufferProjector"});
  return passes;
}

UrpSettings widest(const UrpSettings& a, const UrpSettings& b) {
  UrpSettings result = a;
  for_each_setting(result, b, [](auto& mine, const auto& theirs) {
    if (mine != theirs) mine.reset();
  });
  return result;
}

UrpSettings combined(const UrpSettings& a, const UrpSettings& b) {
  UrpSettings result = a;
  for_each_setting(result, b, [](auto& mine, const auto& theirs) {
    if (theirs) mine = theirs;
  });
  return result;
}

}  // namespace penumbra::variants
