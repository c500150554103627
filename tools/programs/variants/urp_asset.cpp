#include "hlsl/source_text.h"
#include "input/input_error.h"
#include "variants/unity_asset.h"
#include "variants/urp_settings.h"

namespace penumbra::variants {
namespace {

// LightRenderingMode: Disabled 0, PerVertex 2, PerPixel 1. RenderingMode: Forward 0, Deferred 1, ForwardPlus
// 2, and from URP 17.1 DeferredPlus 3, which lights like Deferred and Forward+ at once, so nothing is
// decided.
bool read_field(const AssetField& field, const std::string& file, UrpSettings& settings,
                bool& no_main_light) {
  for (const UrpSwitch& known : urp_switches()) {
    if (field.name != known.field) continue;
    settings.*known.setting = number_in(field, 1, file) == 1;
    return true;
  }
  if (field.name == "m_MainLightRenderingMode") {
    no_main_light = number_in(field, 2, file) == 0;
  } else if (field.name == "m_AdditionalLightsRenderingMode") {
    constexpr AdditionalLights modes[] = {AdditionalLights::disabled, AdditionalLights::per_pixel,
                                          AdditionalLights::per_vertex};
    settings.additional_lights = modes[number_in(field, 2, file)];
  } else if (field.name == "m_RenderingMode") {
    constexpr RenderingMode modes[] = {RenderingMode::forward, RenderingMode::deferred,
                                       RenderingMode::forward_plus};
    const int mode = number_in(field, 3, file);
    if (mode < 3) settings.rendering_mode = modes[mode];
  } else {
    return false;
  }
  return true;
}

}  // namespace

UrpSettings read_urp_asset(std::string_view text, const std::string& name) {
  UrpSettings settings;
  bool known = false;
  bool no_main_light = false;
  for (const AssetField& field : asset_fields(text, name))
    if (field.indent == 2 && field.name.starts_with("m_") && !field.value.empty())
      known |= read_field(field, name, settings, no_main_light);
  if (!known)
    throw InputError(name, "contains no setting of the Universal Render Pipeline",
                     "use a UniversalRenderPipelineAsset or UniversalRendererData, a text .asset file");
  if (no_main_light) settings.main_light_shadows = false;
  return settings;
}

UrpSettings read_urp_assets(const std::vector<std::filesystem::path>& files) {
  std::optional<UrpSettings> assets;
  std::optional<UrpSettings> renderers;
  for (const std::filesystem::path& file : files) {
    const hlsl::SourceRead read = hlsl::read_source(file);
    if (!read.problem.empty()) throw InputError(file.string(), "cannot be read: " + read.problem);
    const UrpSettings settings = read_urp_asset(read.text, file.string());
    const bool is_renderer = read.text.find("\n  m_RenderingMode:") != std::string::npos;
    std::optional<UrpSettings>& kind = is_renderer ? renderers : assets;
    kind = kind ? widest(*kind, settings) : settings;
  }
  return combined(assets.value_or(UrpSettings()), renderers.value_or(UrpSettings()));
}

}  // namespace penumbra::variants
