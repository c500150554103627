#include "variants/urp_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "input/input_error_matcher.h"
#include "variants/program_text.h"

namespace penumbra::variants {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::UnorderedElementsAre;

// The sets are those of a lit forward pass, as any URP shader that takes shadows declares them.
const std::string lights =
    "#pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE _MAIN_LIGHT_SHADOWS_SCREEN\n"
    "#pragma multi_compile _ _ADDITIONAL_LIGHTS_VERTEX _ADDITIONAL_LIGHTS\n"
    "#pragma multi_compile_fragment _ _ADDITIONAL_LIGHT_SHADOWS\n"
    "#pragma multi_compile_fragment _ _SHADOWS_SOFT\n"
    "#pragma multi_compile _ _FORWARD_PLUS\n";

std::vector<std::string> within(const std::string& text, const UrpSettings& settings) {
  return texts_of(
      KeywordSpace(pragmas_of(text), {clauses_of(settings, "s"), {}, settings.xr, {}}).whole_program());
}

TEST(UrpSettings, InvalidCombinationsGoWhateverTheSettings) {
  // Without Forward+ there are 4 main shadows; per-pixel lights with and without shadows, else without; soft
  // with any shadow. (_, vertex): 3 with soft or not + 1; (_ADDITIONAL_LIGHTS): 4 * 2 states, all but one may
  // be soft.
  const auto variants = within(lights + "#pragma skip_variants _FORWARD_PLUS\n", {});
  EXPECT_EQ(variants.size(), 2U * (3 * 2 + 1) + (7 * 2 + 1));
  for (const std::string& variant : variants) {
    const bool soft = variant.find("_SHADOWS_SOFT") != std::string::npos;
    const bool additional = variant.find("_ADDITIONAL_LIGHT_SHADOWS") != std::string::npos;
    const bool pixel =
        variant.find("_ADDITIONAL_LIGHTS _") != std::string::npos || variant.ends_with("_ADDITIONAL_LIGHTS");
    EXPECT_TRUE(!soft || additional || variant.find("_MAIN_LIGHT_SHADOWS") != std::string::npos) << variant;
    EXPECT_TRUE(!additional || pixel) << variant;
  }
  EXPECT_THAT(within("#pragma multi_compile _ DIRLIGHTMAP_COMBINED\n#pragma multi_compile _ LIGHTMAP_ON\n"
                     "#pragma shader_feature EDITOR_VISUALIZATION\n",
                     {}),
              ElementsAre("-", "LIGHTMAP_ON", "DIRLIGHTMAP_COMBINED LIGHTMAP_ON"));
}

TEST(UrpSettings, ForwardPlusDefinesItsLightsItself) {
  UrpSettings settings;
  settings.rendering_mode = RenderingMode::forward_plus;
  settings.main_light_shadows = false;
  settings.screen_space_shadows = false;
  EXPECT_THAT(within(lights, settings),
              ElementsAre("_FORWARD_PLUS", "_ADDITIONAL_LIGHT_SHADOWS _FORWARD_PLUS",
                          "_ADDITIONAL_LIGHT_SHADOWS _SHADOWS_SOFT _FORWARD_PLUS"));
  settings.rendering_mode = RenderingMode::forward;
  settings.additional_lights = AdditionalLights::per_vertex;
  EXPECT_THAT(within(lights, settings), ElementsAre("-", "_ADDITIONAL_LIGHTS_VERTEX"));
  settings.additional_lights = AdditionalLights::disabled;
  EXPECT_THAT(within(lights, settings), ElementsAre("-"));
}

TEST(UrpSettings, DeferredKeepsShadowsOfLightsItDoesNotNeed) {
  UrpSettings settings;
  settings.rendering_mode = RenderingMode::deferred;
  settings.soft_shadows = false;
  EXPECT_THAT(within("#pragma multi_compile _ _ADDITIONAL_LIGHT_SHADOWS\n", settings),
              ElementsAre("-", "_ADDITIONAL_LIGHT_SHADOWS"));
  settings.rendering_mode = RenderingMode::forward;
  EXPECT_THAT(within("#pragma multi_compile _ _ADDITIONAL_LIGHT_SHADOWS\n", settings), ElementsAre("-"));
}

TEST(UrpSettings, CascadesChooseTheirKeyword) {
  UrpSettings settings;
  settings.shadow_cascades = 1;
  const std::string text = "#pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE\n";
  EXPECT_THAT(within(text, settings), ElementsAre("-", "_MAIN_LIGHT_SHADOWS"));
  settings.shadow_cascades = 4;
  EXPECT_THAT(within(text, settings), ElementsAre("-", "_MAIN_LIGHT_SHADOWS_CASCADE"));
}

TEST(UrpSettings, OnMeansAlwaysWhereUrpStripsTheOffVariant) {
  UrpSettings settings;
  settings.light_layers = true;
  settings.light_cookies = true;
  settings.ssao = AmbientOcclusion::on;
  settings.decals = Decals::dbuffer_albedo_normal;
  settings.fog = {Fog::exp2};
  EXPECT_THAT(
      within("#pragma multi_compile _ _LIGHT_LAYERS\n#pragma multi_compile _ _LIGHT_COOKIES\n", settings),
      ElementsAre("_LIGHT_LAYERS", "_LIGHT_LAYERS _LIGHT_COOKIES"));
  EXPECT_THAT(within("#pragma multi_compile _ _SCREEN_SPACE_OCCLUSION\n"
                     "#pragma multi_compile _ _DBUFFER_MRT1 _DBUFFER_MRT2 _DBUFFER_MRT3\n",
                     settings),
              ElementsAre("_SCREEN_SPACE_OCCLUSION _DBUFFER_MRT2"));
  EXPECT_THAT(within("#pragma multi_compile_fog\n", settings), ElementsAre("-", "FOG_EXP2"));
  settings.ssao = AmbientOcclusion::after_opaque;
  settings.decals = Decals::screen_space;
  settings.fog.emplace();
  EXPECT_THAT(within("#pragma multi_compile _ _SCREEN_SPACE_OCCLUSION\n", settings),
              ElementsAre("-", "_SCREEN_SPACE_OCCLUSION"));
  EXPECT_THAT(
      within("#pragma multi_compile _ _DBUFFER_MRT1 _DBUFFER_MRT2\n#pragma multi_compile_fog\n", settings),
      ElementsAre("-"));
}

TEST(UrpSettings, NameThePassesThatGo) {
  EXPECT_THAT(unused_passes({}), IsEmpty());
  UrpSettings settings;
  settings.rendering_mode = RenderingMode::forward;
  settings.main_light_shadows = false;
  EXPECT_THAT(unused_passes(settings), ElementsAre("GBuffer", "UniversalGBuffer"));
  settings.rendering_mode = RenderingMode::deferred;
  settings.additional_light_shadows = false;
  settings.depth_normals = false;
  EXPECT_THAT(unused_passes(settings), ElementsAre("ShadowCaster", "DepthNormals", "DepthNormalsOnly"));
  settings.decals = Decals::gbuffer;
  EXPECT_THAT(unused_passes(settings), IsSupersetOf({"DBufferMesh", "DecalScreenSpaceMesh"}));
}

TEST(UrpSettings, OfSeveralQualityLevelsTheWidestHolds) {
  UrpSettings low;
  low.main_light_shadows = false;
  low.additional_lights = AdditionalLights::per_vertex;
  low.fog = {Fog::exp};
  UrpSettings high = low;
  high.main_light_shadows = true;
  high.xr = {"STEREO_INSTANCING_ON"};
  const UrpSettings both = widest(low, high);
  EXPECT_FALSE(both.main_light_shadows.has_value());
  EXPECT_EQ(both.additional_lights, AdditionalLights::per_vertex);
  EXPECT_EQ(both.fog, (std::vector<Fog>{Fog::exp}));
  EXPECT_THAT(both.xr, ElementsAre("STEREO_INSTANCING_ON"));
  EXPECT_EQ(combined(low, high).main_light_shadows, true);
}

TEST(UrpAsset, IsReadByItsFields) {
  const UrpSettings settings = read_urp_asset(
      "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!114 &11400000\nMonoBehaviour:\n"
      "  m_Name: High\n  m_MainLightRenderingMode: 1\n  m_MainLightShadowsSupported: 1\r\n"
      "  m_AdditionalLightsRenderingMode: 2\n  m_AdditionalLightShadowsSupported: 0\n"
      "  m_ShadowCascadeCount: 4\n  m_SoftShadowsSupported: 0\n  m_SupportsLightLayers: 1\n"
      "  m_Cascade4Split: {x: 0.067, y: 0.2, z: 0.467}\n    m_SupportsLightCookies: 1\n",
      "High.asset");
  EXPECT_EQ(settings.main_light_shadows, true);
  EXPECT_EQ(settings.additional_lights, AdditionalLights::per_vertex);
  EXPECT_EQ(settings.additional_light_shadows, false);
  EXPECT_EQ(settings.soft_shadows, false);
  EXPECT_EQ(settings.light_layers, true);
  EXPECT_FALSE(settings.light_cookies.has_value()) << "a field of something else";
  EXPECT_FALSE(settings.shadow_cascades.has_value()) << "URP keeps both";
}

TEST(UrpAsset, RendererDataGivesTheRenderingMode) {
  const UrpSettings settings =
      read_urp_asset("MonoBehaviour:\n  m_RenderingMode: 2\n  m_AccurateGbufferNormals: 1\n", "r.asset");
  EXPECT_EQ(settings.rendering_mode, RenderingMode::forward_plus);
  EXPECT_EQ(settings.accurate_gbuffer_normals, true);
  EXPECT_EQ(read_urp_asset("  m_RenderingMode: 1\n", "r.asset").rendering_mode, RenderingMode::deferred);
  EXPECT_FALSE(read_urp_asset("  m_RenderingMode: 3\n", "r.asset").rendering_mode.has_value());
}

TEST(UrpAsset, NoMainLightCastsNoShadow) {
  EXPECT_EQ(read_urp_asset("  m_MainLightShadowsSupported: 1\n  m_MainLightRenderingMode: 0\n", "a")
                .main_light_shadows,
            false);
}

// There are two quality levels of which one casts soft shadows, and one renderer: both levels' variants are
// needed.
TEST(UrpAsset, QualityLevelsWidenAndTheirRendererAdds) {
  const std::filesystem::path folder = testing::TempDir();
  const auto write = [&](const char* name, const std::string& text) {
    std::ofstream(folder / name) << "MonoBehaviour:\n" << text;
    return folder / name;
  };
  const UrpSettings settings =
      read_urp_assets({write("low.asset", "  m_SoftShadowsSupported: 0\n  m_SupportsLightLayers: 0\n"),
                       write("renderer.asset", "  m_RenderingMode: 1\n  m_AccurateGbufferNormals: 0\n"),
                       write("high.asset", "  m_SoftShadowsSupported: 1\n  m_SupportsLightLayers: 0\n")});
  EXPECT_FALSE(settings.soft_shadows.has_value());
  EXPECT_EQ(settings.light_layers, false);
  EXPECT_EQ(settings.rendering_mode, RenderingMode::deferred);
  EXPECT_EQ(settings.accurate_gbuffer_normals, false);
  expect_input_error([&] { read_urp_assets({folder / "none.asset"}); },
                     HasSubstr("none.asset: cannot be read"));
}

TEST(UrpAsset, SaysWhatIsWrong) {
  expect_input_error([] { read_urp_asset("a\n  m_SoftShadowsSupported: yes\n", "x.asset"); },
                     "x.asset:2: 'm_SoftShadowsSupported' must be an integer from 0 to 1, found 'yes'");
  expect_input_error([] { read_urp_asset("  m_RenderingMode: 9\n", "x.asset"); },
                     "x.asset:1: 'm_RenderingMode' must be an integer from 0 to 3, found '9'");
  expect_input_error([] { read_urp_asset("%YAML 1.1\n  m_Shader: 1\n", "x.mat"); },
                     "x.mat: contains no setting of the Universal Render Pipeline\n  use a "
                     "UniversalRenderPipelineAsset or UniversalRendererData, a text .asset file");
  expect_input_error([] { read_urp_asset(std::string_view("a\0b", 3), "x.asset"); },
                     HasSubstr("x.asset: is a binary asset\n  set Project Settings"));
}

}  // namespace
}  // namespace penumbra::variants
