#include "variants/narrowing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "input/input_error_matcher.h"
#include "variants/program_text.h"

namespace penumbra::variants {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

std::vector<std::string> narrowed(const std::string& text, const std::string& stripping) {
  return texts_of(KeywordSpace(pragmas_of(text), parse_stripping(stripping, "s.json")).whole_program());
}

TEST(Stripping, KeywordsAreAlwaysNeverOrBoth) {
  const std::string text =
      "#pragma multi_compile _ A\n#pragma multi_compile _ B\n#pragma multi_compile _ C\n";
  EXPECT_THAT(narrowed(text, R"({"keywords": {"A": "always", "B": "never", "C": "both"}})"),
              ElementsAre("A", "A C"));
  EXPECT_THAT(narrowed(text, "{}"), SizeIs(8));
}

TEST(Stripping, SettingsOfUrpAreTakenBackByName) {
  const std::string text = "#pragma multi_compile _ DEBUG_DISPLAY\n#pragma multi_compile _ _LIGHT_LAYERS\n";
  EXPECT_THAT(narrowed(text, R"({"urp": {"debug_display": false, "light_layers": true}})"),
              ElementsAre("_LIGHT_LAYERS"));
  EXPECT_THAT(narrowed(text, R"({"urp": {"debug_display": false, "light_layers": true},
                                 "keywords": {"DEBUG_DISPLAY": "both", "_LIGHT_LAYERS": "never"}})"),
              ElementsAre("-", "DEBUG_DISPLAY"));
}

TEST(Stripping, EverySettingOfUrpHasItsKey) {
  const Narrowing narrowing = parse_stripping(R"({"urp": {
      "main_light_shadows": true, "screen_space_shadows": false, "shadow_cascades": 4,
      "additional_lights": "per_pixel", "additional_light_shadows": true, "soft_shadows": true,
      "light_layers": false, "light_cookies": false, "reflection_probe_blending": true,
      "reflection_probe_box_projection": false, "mixed_lighting": true, "lightmaps": true,
      "directional_lightmaps": false, "realtime_lightmaps": false, "fog": ["exp2", "linear"],
      "rendering_mode": "forward_plus", "accurate_gbuffer_normals": false, "render_pass": false,
      "decals": "screen_space", "decal_normal_blend": "high", "decal_layers": false, "ssao": "after_opaque",
      "write_rendering_layers": false, "fast_srgb_conversion": false, "lod_cross_fade": true,
      "debug_display": false, "gpu_instancing": true, "dots_instancing": false, "depth_normals": true,
      "xr": ["instancing", "multiview", "single_pass"]}})",
                                              "s.json");
  EXPECT_THAT(narrowing.stereo_modes,
              ElementsAre("STEREO_INSTANCING_ON", "STEREO_MULTIVIEW_ON", "UNITY_SINGLE_PASS_STEREO"));
  EXPECT_THAT(texts_of(KeywordSpace(pragmas_of("#pragma multi_compile_fog\n"), narrowing).whole_program()),
              SizeIs(3 * 4));
}

TEST(Stripping, MaterialsMeanUsed) {
  const std::string text = "#pragma shader_feature A\n#pragma shader_feature B\n";
  EXPECT_THAT(narrowed(text, R"({"materials": [["A"], ["A"], ["A", "B"]]})"), ElementsAre("A", "A B"));
  EXPECT_THAT(narrowed(text, R"({"materials": [["A"]], "shader_feature": "used"})"), ElementsAre("A"));
  EXPECT_THAT(narrowed(text, R"({"shader_feature": "used"})"), ElementsAre("-"));
  EXPECT_THAT(narrowed(text, R"({"shader_feature": "all"})"), SizeIs(4));
}

TEST(Stripping, SaysWhereAndWhat) {
  const std::pair<const char*, const char*> cases[] = {
      {R"({"keyword": {}})", "s.json:1:2: unknown key 'keyword'\n  did you mean 'keywords'?"},
      {R"({"keywords": {"A": "on"}})", "s.json:1:15: 'A' cannot be 'on'\n  known are: always never both"},
      {R"({"keywords": {"A B": "never"}})", "s.json:1:15: 'A B' is not a keyword"},
      {"{\"urp\": {\n  \"fogg\": []}}", "s.json:2:3: unknown key 'fogg'\n  did you mean 'fog'?"},
      {R"({"urp": {"fog": ["exp3"]}})", "s.json:1:10: 'fog' cannot be 'exp3'\n  did you mean 'exp'?"},
      {R"({"urp": {"xr": ["steam"]}})",
       "s.json:1:10: 'xr' cannot be 'steam'\n  known are: instancing multiview single_pass"},
      {R"({"urp": {"additional_lights": "pixel"}})",
       "s.json:1:10: 'additional_lights' cannot be 'pixel'\n  did you mean 'per_pixel'?"},
      {R"({"urp": {"soft_shadows": 1}})",
       "s.json:1:10: 'soft_shadows' must be true or false, found a number"},
      {R"({"urp": {"shadow_cascades": 5}})", "s.json:1:10: 'shadow_cascades' must be from 1 to 4"},
      {R"({"materials": ["A"]})",
       "s.json:1:18: 'materials' must be an array of keyword arrays: [[\"_NORMALMAP\"], []]"},
      {R"({"materials": [["A", 3]]})", "s.json:1:23: a keyword must be a string"},
      {R"({"materials": [["A,B"]]})", "s.json:1:21: 'A,B' is not a keyword"},
      {R"({"shader_feature": "all", "materials": []})",
       "s.json:1:2: \"materials\" has no effect together with \"all\"\n  remove one of the two"},
      {R"({"shader_feature": "some"})",
       "s.json:1:2: 'shader_feature' cannot be 'some'\n  known are: used all"},
  };
  for (const auto& [text, message] : cases) {
    expect_input_error([&, json = text] { parse_stripping(json, "s.json"); }, message);
  }
}

}  // namespace
}  // namespace penumbra::variants
