// Tests what manifests say of the shader keywords and of the renderer feature's options, and what is emitted
// of it.
#include "techniques/selection.h"

#include <gmock/gmock.h>

#include "techniques/feature_tables.h"
#include "techniques/manifest_test.h"
#include "techniques/selection_hlsl.h"
#include "techniques/settings_emit.h"

namespace penumbra::techniques {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* ring_manifest = R"({
  "structs": [{"name": "RingParameters", "doc": "A ring.", "fields": [
    {"name": "taps", "type": "int", "unit": "taps", "doc": "on it", "default": 8}]}],
  "options": [
    {"name": "ringTaps", "type": "int", "label": "Taps", "range": [4, 32], "tooltip": "On the ring, 4 to 32."},
    {"name": "ringWidth", "type": "float", "label": "Width", "range": [0, 2], "tooltip": "Of the ring \"as is\"."},
    {"name": "quiet", "type": "bool", "label": "Quiet", "tooltip": "Says nothing."}],
  "defaults": {"family": "ring", "source": "Nobody 1900"},
  "techniques": [
    {"name": "plain", "title": "Plain", "filter": {"file": "Ring.hlsl", "function": "FilterPlain"}},
    {"name": "wide", "title": "Wide", "filter": {"file": "Ring.hlsl", "function": "FilterWide"}},
    {"name": "ring", "title": "Ring", "unlimited": {"taps": 99},
     "filter": {"file": "Ring.hlsl", "function": "FilterRing", "arguments": ["shadowMap", "pointSampler"],
                "parameters": "RingParameters"}}],
  "selections": [
    {"name": "Plain", "value": 1, "title": "Plain", "doc": "One tap.", "technique": "plain"},
    {"name": "Wide", "keyword": "_PENUMBRA_WIDE", "technique": "wide"},
    {"name": "Ring", "value": 0, "keyword": "_PENUMBRA_RING", "technique": "ring", "fallback": "Wide",
     "title": "Ring", "doc": "A ring.", "options": {"ringTaps": "taps"}}]
})";

class SelectionTest : public ManifestTest {
 protected:
  SelectionTest() : ManifestTest("ring.technique.json", {"Ring.hlsl", "Ring.shader"}) {}

  static std::string with(const std::string& from, const std::string& to) {
    return replaced(ring_manifest, from, to);
  }
  void use(const TechniqueList& list) const override {
    emit_keywords_hlsl(list);
    selection_rows(list);
  }
};

TEST_F(SelectionTest, TakesTheFilterOfItsTechnique) {
  const TechniqueList list = read(ring_manifest);
  ASSERT_EQ(list.selections.size(), 3U);
  const Selection& ring = list.selections[2];
  EXPECT_EQ(ring.filter.function, "FilterRing");
  EXPECT_TRUE(ring.is_sampled);
  EXPECT_TRUE(ring.reads_raw_depth());
  EXPECT_EQ(ring.options, (std::map<std::string, std::string>{{"ringTaps", "taps"}}));
  EXPECT_FALSE(list.selections[1].value);
}

TEST_F(SelectionTest, IsEmittedAsTheLadderOfKeywords) {
  const std::string text = emit_keywords_hlsl(read(ring_manifest));
  EXPECT_THAT(text, HasSubstr("#if defined(PENUMBRA_WITHOUT_GATHER) && \\\n    (defined(_PENUMBRA_RING))\n"
                              "#define PENUMBRA_USES_WIDE\n"
                              "#elif defined(_PENUMBRA_WIDE)\n#define PENUMBRA_USES_WIDE\n"
                              "#elif defined(_PENUMBRA_RING)\n#define PENUMBRA_USES_RING\n"
                              "#define PENUMBRA_READS_RAW_DEPTH\n#endif\n"));
  EXPECT_THAT(text, HasSubstr("float4 _PenumbraRingParameters0;\n\nRingParameters PenumbraRing()\n{\n"
                              "    return UnpackRingParameters(_PenumbraRingParameters0);\n}\n"));
  EXPECT_THAT(text,
              HasSubstr("#elif defined(PENUMBRA_USES_RING)\n"
                        "    return FilterRing(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), "
                        "sampler_point, receiver, tile,\n                      PenumbraRing());\n#else\n"
                        "    return FilterPlain(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), "
                        "receiver, tile);\n#endif\n"));
}

TEST_F(SelectionTest, ItsCallIsWrappedWhereItsMapsAreMany) {
  const std::string graph = R"("graphs": [{"name": "rings",
    "textures": [{"name": "nearestOfAllTexels", "extent": "map", "format": "rgba32f"},
                 {"name": "farthestOfAllTexels", "extent": "map", "format": "rgba32ui"}],
    "passes": [{"name": "Make", "kind": "raster", "shader": "Ring.shader", "runs": "cascade",
                "writes": ["nearestOfAllTexels", "farthestOfAllTexels"]},
               {"name": "filter", "kind": "filter", "filter": {"file": "Ring.hlsl", "function": "FilterRing",
                "arguments": ["shadowMap", "pointSampler", "nearestOfAllTexels", "farthestOfAllTexels"],
                "parameters": "RingParameters"}}]}],
  "defaults")";
  const std::string filter =
      R"("filter": {"file": "Ring.hlsl", "function": "FilterRing", "arguments": ["shadowMap", "pointSampler"],
                "parameters": "RingParameters"})";
  const std::string text =
      emit_keywords_hlsl(read(replaced(with(R"("defaults")", graph), filter, R"("graph": "rings")")));
  EXPECT_THAT(text, HasSubstr("TEXTURE2D(_PenumbraNearestOfAllTexelsTexture);\n"
                              "Texture2D<uint4> _PenumbraFarthestOfAllTexelsTexture;\n"));
  EXPECT_THAT(text, HasSubstr("    return FilterRing(TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap), "
                              "sampler_point,\n"
                              "                      _PenumbraNearestOfAllTexelsTexture, "
                              "_PenumbraFarthestOfAllTexelsTexture, receiver, tile,\n"
                              "                      PenumbraRing());\n"));
}

TEST_F(SelectionTest, IsEmittedForTheFeatureByItsValue) {
  const TechniqueList list = read(with(R"("fallback": "Wide")", R"("fallback": "Plain")"));
  const std::string text = emit_selections_csharp(list);
  EXPECT_THAT(text,
              HasSubstr("/// <summary>A ring.</summary>\n        [InspectorName(\"Ring\")] Ring = 0,\n"));
  EXPECT_THAT(text, HasSubstr("Plain = 1,\n    }\n"));
  EXPECT_THAT(text, Not(HasSubstr("Wide")));
}

// The option begins as it is measured, and sets its field within the field's range.
TEST_F(SelectionTest, IsRowsOfTheTableOfTechniques) {
  const std::string manifest = with(R"("fallback": "Wide")", R"("fallback": "Plain")");
  const auto rows = [](const std::string& vector) {
    return "technique\tRing\tPlain\tkeyword=_PENUMBRA_RING\ttakesSamples\twidensWithDisc\tneedsTarget45\n"
           "option\tringTaps\t8\nformat\n" +
           vector + "technique\tPlain\tPlain\nformat\n";
  };
  EXPECT_EQ(selection_rows(read(manifest)),
            rows("vector\t_PenumbraRingParameters0\tringTaps:-3.4028235e+38:3.4028235e+38\t0\t0\t0\n"));
  std::string ranged = manifest;
  ranged.replace(ranged.find(R"("default": 8)"), 12, R"("default": 8, "range": [1, 16])");
  EXPECT_EQ(selection_rows(read(ranged)), rows("vector\t_PenumbraRingParameters0\tringTaps:1:16\t0\t0\t0\n"));
}

TEST_F(SelectionTest, ParametersThatTheFeatureComputesAreNotSetBesides) {
  const std::string rows = selection_rows(read(
      with(R"("fallback": "Wide")", R"("fallback": "Plain", "computed_parameters": ["RingParameters"])")));
  EXPECT_THAT(rows, Not(HasSubstr("vector")));
  EXPECT_THAT(rows, HasSubstr("option\tringTaps\t8\n")) << "but they begin as they are measured";
  refuse(ring_manifest, R"("fallback": "Wide")", R"("fallback": "Plain", "computed_parameters": ["Rings"])",
         "unknown struct 'Rings'");
}

TEST_F(SelectionTest, AFallbackMayBeTheFilterWithoutAKeyword) {
  const std::string text = emit_keywords_hlsl(read(with(R"("fallback": "Wide")", R"("fallback": "Plain")")));
  EXPECT_THAT(text, HasSubstr("#if defined(PENUMBRA_WITHOUT_GATHER) && \\\n    (defined(_PENUMBRA_RING))\n"
                              "#elif defined(_PENUMBRA_WIDE)\n"));
}

TEST_F(SelectionTest, OptionsAreEmittedWithTheirRanges) {
  const std::string text = emit_options_csharp(read(ring_manifest));
  EXPECT_THAT(text, HasSubstr("        internal static class RingTaps\n        {\n"
                              "            internal const string Label = \"Taps\", Tooltip =\n"
                              "                \"On the ring, 4 to 32.\";\n"
                              "            internal const int Min = 4, Max = 32;\n        }\n"));
  EXPECT_THAT(
      text,
      HasSubstr(
          "\"Of the ring \\\"as is\\\".\";\n            internal const float Min = 0.0f, Max = 2.0f;\n"));
  EXPECT_THAT(text, HasSubstr("enum NumberOption\n    {\n        ringTaps, ringWidth\n    }\n"));
  EXPECT_THAT(text, HasSubstr("case NumberOption.ringWidth: return options.ringWidth;\n"));
  EXPECT_THAT(text, HasSubstr("case NumberOption.ringTaps: options.ringTaps = (int)value; break;\n"));
}

// The passes end in a texture, over the screen.
constexpr const char* disc_manifest = R"({
  "order": 2,
  "graphs": [
    {"name": "disc", "textures": [{"name": "visibility", "format": "r8"}],
     "passes": [{"name": "Disc", "kind": "raster", "shader": "Disc.shader", "writes": ["visibility"],
                 "parameters": ["RingParameters"]}], "visibility": "visibility"}],
  "defaults": {"family": "disc", "source": "Nobody 1901"},
  "techniques": [
    {"name": "disc", "title": "Disc", "graph": "disc"},
    {"name": "preset-low", "title": "Preset Low: Disc of 12", "graph": "disc", "values": {"taps": 12}},
    {"name": "rings-12", "title": "Ring of 12", "filter": {"file": "Ring.hlsl", "function": "FilterRing",
     "arguments": ["shadowMap", "pointSampler"], "parameters": "RingParameters"}, "keywords": ["_PENUMBRA_RING"],
     "values": {"taps": 12}}],
  "selections": [
    {"name": "Disc", "value": 2, "technique": "disc", "fallback": "Ring",
     "title": "Disc", "doc": "A disc.", "options": {"ringTaps": "taps"}}],
  "presets": [{"preset": "preset-low", "fallback": "rings-12"}]
})";

// Tests selections of passes that draw the visibility, after those of the ring.
class VisibilitySelectionTest : public SelectionTest {
 protected:
  VisibilitySelectionTest() {
    files_.write("ShaderLibrary/Ring.hlsl", "// ring\n");
    files_.write("ShaderLibrary/ring.technique.json",
                 with(R"("fallback": "Wide")", R"("fallback": "Plain")"));
    files_.write("ShaderLibrary/Disc.shader", "// disc\n");
    manifest_ = "ShaderLibrary/disc.technique.json";
  }

  TechniqueList read(const std::string& text) const override {
    files_.write(manifest_, text);
    return read_technique_list(files_.path(""));
  }
  void use(const TechniqueList& list) const override {
    selection_rows(list);
    emit_presets_csharp(list);
  }
};

TEST_F(VisibilitySelectionTest, HasItsFallbacksKeywordAndIsNotInShaders) {
  const TechniqueList list = read(disc_manifest);
  const Selection& disc = list.selections.back();
  EXPECT_TRUE(disc.draws_visibility);
  EXPECT_EQ(disc.keyword, "_PENUMBRA_RING");
  EXPECT_EQ(emit_keywords_hlsl(list),
            emit_keywords_hlsl(ManifestTest::read(with(R"("fallback": "Wide")", R"("fallback": "Plain")"))));
}

TEST_F(VisibilitySelectionTest, IsEmittedWithItsGraphAndItsFallback) {
  EXPECT_THAT(
      selection_rows(read(disc_manifest)),
      HasSubstr("technique\tDisc\tRing\tkeyword=_PENUMBRA_RING\noption\tringTaps\t8\nformat\tgraph=disc\n"
                "vector\t_PenumbraRingParameters0\tringTaps:"));
}

TEST_F(VisibilitySelectionTest, ItsGraphAtHalfResolutionIsBesideIt) {
  std::string manifest = replaced(disc_manifest, R"("fallback": "Ring")",
                                  R"("fallback": "Ring", "technique_half_resolution": "disc-half")");
  manifest = replaced(manifest, R"({"name": "disc", "textures")",
                      R"({"name": "disc-half", "textures": [{"name": "visibility", "format": "r8"}],
     "passes": [{"name": "Disc", "kind": "raster", "shader": "Disc.shader", "writes": ["visibility"],
                 "parameters": ["RingParameters"]}], "visibility": "visibility"},
    {"name": "disc", "textures")");
  manifest = replaced(
      manifest, R"({"name": "preset-low")",
      R"({"name": "disc-half", "title": "Half a disc", "graph": "disc-half"}, {"name": "preset-low")");
  EXPECT_THAT(selection_rows(read(manifest)), HasSubstr("half\tdisc-half\nformat\tgraph=disc\n"));
}

TEST_F(VisibilitySelectionTest, APresetDrawsItOrItsFallbackWithTheSameOptions) {
  const std::string text = emit_presets_csharp(read(disc_manifest));
  EXPECT_THAT(text, HasSubstr("// Preset Low: Disc of 12\n            new ShadowOptions\n"));
  EXPECT_THAT(text, HasSubstr("technique = ShadowTechnique.Disc, "));
  EXPECT_THAT(text, HasSubstr("ringTaps = 12, ")) << "as what it draws is measured, not as the first with it";
}

// Upsampling calls the fallback's filter in the same way.
TEST_F(VisibilitySelectionTest, APresetWhosePassesCallTheFallbacksFilterHasItsOptions) {
  const auto problem_of = [this](const std::string& manifest) {
    const std::string text = replaced(manifest, R"("options": {"ringTaps": "taps"})", R"("options": {})");
    return input_error_of([&] {
      read(replaced(text, R"("graph": "disc", "values": {"taps": 12})",
                    R"("graph": "disc", "values": {"taps": 8})"));
    });
  };
  EXPECT_EQ(problem_of(disc_manifest), "no error") << "its passes' own parameter, which no option sets";
  EXPECT_THAT(problem_of(replaced(disc_manifest, R"("parameters": ["RingParameters"])",
                                  R"("filter": {"file": "Ring.hlsl", "function": "FilterRing", "arguments": )"
                                  R"(["shadowMap", "pointSampler"], "parameters": "RingParameters"})")),
              HasSubstrs("disc.technique.json:17:", "'preset-low' and 'rings-12' differ in 'taps'"));
}

TEST_F(VisibilitySelectionTest, MistakesAreNamedAtTheirLine) {
  const auto at = [](const char* line) { return std::string("disc.technique.json:") + line + ":"; };
  refuse(disc_manifest, R"("value": 2, )", R"("value": 2, "keyword": "_PENUMBRA_DISC", )", at("15"),
         "'disc' ends in a texture", "leave the keyword out");
  const std::string offered = R"("value": 2, "technique": "disc", "fallback": "Ring",
     "title": "Disc", "doc": "A disc.", "options": {"ringTaps": "taps"})";
  refuse(disc_manifest, offered, R"("technique": "disc", "fallback": "Ring")", at("15"), "give it a value");
  refuse(disc_manifest, R"("fallback": "Ring")", R"("fallback": "Disc")", at("15"),
         "unknown selection 'Disc'");
  refuse(disc_manifest, R"("fallback": "Ring")", R"("fallback": "Ring", "technique_16_bits": "preset-low")",
         at("15"), "'preset-low' is not the filter");
  refuse(disc_manifest, R"("fallback": "Ring")", R"("fallback": "Ring", "technique_half_resolution": "ring")",
         at("15"), "'ring' does not end in a texture, as 'disc' does");
  refuse(disc_manifest, R"("preset": "preset-low")", R"("preset": "plain")", at("17"),
         "'plain' is not a preset");
  refuse(disc_manifest, R"("preset": "preset-low")", R"("preset": "preset-lower")", at("17"),
         "unknown technique 'preset-lower'");
  refuse(disc_manifest, R"("fallback": "rings-12"})", R"("fallback": "rings-13"})", at("17"),
         "unknown technique 'rings-13'");
  refuse(disc_manifest, R"("graph": "disc", "values": {"taps": 12})",
         R"("filter": {"file": "Ring.hlsl", "function": "FilterRing", "arguments": ["shadowMap"],)"
         R"( "parameters": "RingParameters"}, "values": {"taps": 12})",
         at("17"), "no selection has the passes of 'preset-low'");
  refuse(disc_manifest, R"("graph": "disc", "values": {"taps": 12})",
         R"("graph": "disc", "values": {"taps": 8})", at("17"),
         "'preset-low' and 'rings-12' differ in 'taps'");
  refuse(disc_manifest, R"("keywords": ["_PENUMBRA_RING"])", R"("keywords": ["_PENUMBRA_WIDE"])", at("17"),
         "'rings-12' has not the keyword of 'Ring'");
  refuse(disc_manifest, R"("presets": [)",
         R"("presets": [{"preset": "preset-low", "fallback": "rings-12"}, )", at("17"),
         "there are two fallbacks of 'preset-low'");
  refuse(disc_manifest, R"(  "presets": [{"preset": "preset-low", "fallback": "rings-12"}])",
         R"(  "presets": [])", "the preset 'preset-low' has no fallback");
  refuse(disc_manifest, R"("passes": [{"name": "Disc")", R"("passes": [{"name": "Upsample")", at("17"),
         "of 'preset-low' and 'rings-12', one is at half resolution");
}

TEST_F(SelectionTest, MistakesAreNamedAtTheirLine) {
  const auto at = [](const char* line) { return std::string("ring.technique.json:") + line + ":"; };
  refuse(ring_manifest, R"("technique": "plain"})", R"("technique": "plane"})", at("16"),
         "unknown technique 'plane'", "did you mean 'plain'?");
  refuse(ring_manifest, R"("name": "Wide")", R"("name": "Plain")", at("17"),
         "there are two selections 'Plain'");
  refuse(ring_manifest, "_PENUMBRA_RING", "_PENUMBRA_WIDE", at("18"),
         "'Wide' has the keyword '_PENUMBRA_WIDE'");
  refuse(ring_manifest, R"(, "fallback": "Wide")", "", "'fallback' is missing");
  refuse(ring_manifest, R"("fallback": "Wide")", R"("fallback": "Ring")", at("18"),
         "unknown selection 'Ring'");
  refuse(ring_manifest, R"("technique": "wide"})", R"("technique": "wide", "fallback": "Plain"})", at("17"),
         "'Wide' reads no raw depths");
  refuse(ring_manifest, R"("value": 0)", R"("value": 1)", at("18"), "'Plain' has the value 1");
  refuse(ring_manifest, R"("value": 0)", R"("value": 2)", at("16"), "no selection has the value 0");
  refuse(ring_manifest, R"("ringTaps": "taps")", R"("ringTapes": "taps")", at("19"),
         "unknown option 'ringTapes'");
  refuse(ring_manifest, R"("ringTaps": "taps")", R"("ringTaps": "tapes")", at("19"), "unknown field 'tapes'");
  refuse(ring_manifest, R"("ringTaps": "taps")", R"("ringWidth": "taps")", at("19"),
         "'ringWidth' is of type float, the field 'taps' of type int");
  refuse(ring_manifest, R"("fallback": "Wide")", R"("fallback": "Wide", "technique_16_bits": "wide")",
         at("18"), "'wide' is not the filter 'FilterRing' over maps, as 'ring' is");
  refuse(ring_manifest, R"("fallback": "Wide")", R"("fallback": "Wide" )", at("18"),
         "the renderer feature does not offer 'Wide', which is drawn where");
  refuse(ring_manifest, R"(, "technique": "plain"})",
         R"(, "keyword": "_PENUMBRA_PLAIN", "technique": "plain"})", "no selection is without a keyword");
  refuse(ring_manifest, R"("range": [4, 32])", R"("range": [32, 4])", at("5"),
         "the smallest value is not below the largest");
  refuse(ring_manifest, R"("name": "quiet")", R"("name": "ringTaps")", at("7"),
         "there are two options 'ringTaps'");
}

}  // namespace
}  // namespace penumbra::techniques
