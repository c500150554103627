#include <algorithm>

#include "variants/urp_settings.h"

namespace penumbra::variants {
namespace {

// Calls visit(result, other) for every setting that may be absent.
template <typename Visit>
void for_each_setting(UrpSettings& result, const UrpSettings& other, Visit visit) {
  visit(result.main_light_shadows, other.main_light_shadows);
  visit(result.screen_space_shadows, other.screen_space_shadows);
  visit(result.shadow_cascades, other.shadow_cascades);
  visit(result.additional_lights, other.additional_lights);
  visit(result.additional_light_shadows, other.additional_light_shadows);
  visit(result.soft_shadows, other.soft_shadows);
  visit(result.light_layers, other.light_layers);
  visit(result.light_cookies, other.light_cookies);
  visit(result.reflection_probe_blending, other.reflection_probe_blending);
  visit(result.reflection_probe_box_projection, other.reflection_probe_box_projection);
  visit(result.mixed_lighting, other.mixed_lighting);
  visit(result.lightmaps, other.lightmaps);
  visit(result.directional_lightmaps, other.directional_lightmaps);
  visit(result.realtime_lightmaps, other.realtime_lightmaps);
  visit(result.fog, other.fog);
  visit(result.rendering_mode, other.rendering_mode);
  visit(result.accurate_gbuffer_normals, other.accurate_gbuffer_normals);
  visit(result.render_pass, other.render_pass);
  visit(result.decals, other.decals);
  visit(result.decal_normal_blend, other.decal_normal_blend);
  visit(result.decal_layers, other.decal_layers);
  visit(result.ssao, other.ssao);
  visit(result.write_rendering_layers, other.write_rendering_layers);
  visit(result.fast_srgb_conversion, other.fast_srgb_conversion);
  visit(result.lod_cross_fade, other.lod_cross_fade);
  visit(result.debug_display, other.debug_display);
  visit(result.gpu_instancing, other.gpu_instancing);
  visit(result.dots_instancing, other.dots_instancing);
  visit(result.depth_normals, other.depth_normals);
}

void add_stereo(UrpSettings& result, const UrpSettings& other) {
  for (const std::string& mode : other.xr) {
    if (std::find(result.xr.begin(), result.xr.end(), mode) == result.xr.end()) result.xr.push_back(mode);
  }
}

}  // namespace

UrpSettings widest(const UrpSettings& a, const UrpSettings& b) {
  UrpSettings result = a;
  for_each_setting(result, b, [](auto& mine, const auto& theirs) {
    if (mine != theirs) mine.reset();
  });
  add_stereo(result, b);
  return result;
}

UrpSettings combined(const UrpSettings& a, const UrpSettings& b) {
  UrpSettings result = a;
  for_each_setting(result, b, [](auto& mine, const auto& theirs) {
    if (theirs) mine = theirs;
  });
  add_stereo(result, b);
  return result;
}

}  // namespace penumbra::variants
