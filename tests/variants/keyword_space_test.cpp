#include "variants/keyword_space.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "input/input_error_matcher.h"
#include "variants/program_text.h"

namespace penumbra::variants {
namespace {

using hlsl::Stage;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

KeywordSpace space_of(const std::string& text, const Narrowing& narrowing = {}) {
  return KeywordSpace(pragmas_of(text), narrowing);
}

std::string sets_with_unique_keywords(int sets, int keywords) {
  std::string text;
  for (int i = 0; i < sets; ++i) {
    text += "#pragma multi_compile _";
    for (int j = 0; j < keywords; ++j) text += " K" + std::to_string(i) + "_" + std::to_string(j);
    text += "\n";
  }
  return text;
}

// The example is that of the Unity Manual, "Shader variants": two sets of three and four keywords make twelve
// variants.
TEST(KeywordSpace, SetsMultiply) {
  const KeywordSpace space =
      space_of("#pragma multi_compile COLOR_RED COLOR_GREEN COLOR_BLUE\n#pragma multi_compile Q1 Q2 Q3 Q4\n");
  EXPECT_EQ(space.whole_program().count(), VariantCount(12));
  EXPECT_EQ(space.variants(Stage::vertex).count(), VariantCount(12));
}

TEST(KeywordSpace, TheFirstSetVariesSlowest) {
  EXPECT_THAT(texts_of(space_of("#pragma multi_compile _ A\n#pragma shader_feature B C\n").whole_program()),
              ElementsAre("B", "C", "A B", "A C"));
}

TEST(KeywordSpace, AProgramWithoutKeywordsHasOneVariant) {
  EXPECT_THAT(texts_of(space_of("#pragma vertex V\n").whole_program()), ElementsAre("-"));
}

TEST(KeywordSpace, AStageSeesItsOwnSets) {
  const KeywordSpace space = space_of(
      "#pragma multi_compile _ A\n#pragma multi_compile_fragment B C\n#pragma multi_compile_vertex _ D\n"
      "#pragma multi_compile_raytracing _ E\n");
  EXPECT_THAT(texts_of(space.variants(Stage::vertex)), ElementsAre("-", "D", "A", "A D"));
  EXPECT_THAT(texts_of(space.variants(Stage::fragment)), ElementsAre("B", "C", "A B", "A C"));
  EXPECT_THAT(texts_of(space.variants(Stage::geometry)), ElementsAre("-", "A"));
  EXPECT_EQ(space.whole_program().count(), VariantCount(16));
}

TEST(KeywordSpace, DynamicKeywordsMultiplyNothing) {
  const KeywordSpace space = space_of("#pragma dynamic_branch A B\n#pragma multi_compile _ C\n");
  EXPECT_EQ(space.whole_program().count(), VariantCount(2));
  EXPECT_THAT(space.dynamic_keywords(), SizeIs(2));
}

TEST(KeywordSpace, TheSameSetTwiceCountsOnceForEachCombination) {
  EXPECT_THAT(texts_of(space_of("#pragma multi_compile _ A\n#pragma multi_compile _ A\n").whole_program()),
              ElementsAre("-", "A"));
  EXPECT_THAT(texts_of(space_of("#pragma multi_compile _ A B\n#pragma multi_compile _ A\n").whole_program()),
              ElementsAre("-", "A", "B", "A B"));
}

TEST(KeywordSpace, ASharedKeywordIsSeenWhereAnyOfItsSetsIs) {
  const KeywordSpace space =
      space_of("#pragma multi_compile_vertex _ A\n#pragma multi_compile_fragment _ A B\n");
  EXPECT_THAT(texts_of(space.variants(Stage::vertex)), ElementsAre("-", "A"));
  EXPECT_THAT(texts_of(space.variants(Stage::fragment)), ElementsAre("-", "A", "B", "A B"));
}

TEST(KeywordSpace, ShortcutsCountTheirCombinations) {
  EXPECT_EQ(space_of("#pragma multi_compile_fwdadd_fullshadows\n").whole_program().count(),
            VariantCount(13U * 4U));
  // There are 7 of the 8 lightmap combinations, and 5 free keywords.
  EXPECT_EQ(space_of("#pragma multi_compile_fwdbase\n").whole_program().count(), VariantCount(7U * 32U));
  EXPECT_THAT(texts_of(space_of("#pragma multi_compile_fwdbase\n"
                                "#pragma skip_variants LIGHTMAP_ON DYNAMICLIGHTMAP_ON LIGHTMAP_SHADOW_MIXING "
                                "SHADOWS_SHADOWMASK VERTEXLIGHT_ON\n")
                           .whole_program()),
              ElementsAre("DIRECTIONAL", "DIRECTIONAL LIGHTPROBE_SH", "DIRECTIONAL SHADOWS_SCREEN",
                          "DIRECTIONAL SHADOWS_SCREEN LIGHTPROBE_SH"));
}

TEST(KeywordSpace, ClausesNarrow) {
  const std::string text = "#pragma multi_compile _ A B\n#pragma multi_compile _ C\n";
  const auto variants = [&](const Clause& clause) {
    return texts_of(space_of(text, {{clause}, {}, {}, {}}).whole_program());
  };
  EXPECT_THAT(variants(never("A", "")), ElementsAre("-", "C", "B", "B C"));
  EXPECT_THAT(variants(always("A", "")), ElementsAre("A", "A C"));
  EXPECT_THAT(variants(needs("C", {"B"}, "")), ElementsAre("-", "A", "B", "B C"));
  EXPECT_THAT(variants({"", {"A", "C"}, false, false, false, ""}), ElementsAre("C", "A", "A C", "B C"));
  EXPECT_THAT(variants({"", {"A", "C"}, false, true, false, ""}), ElementsAre("A C"));
  EXPECT_THAT(variants({"", {"A", "C"}, false, true, true, ""}), ElementsAre("-", "C", "A", "A C"));
  EXPECT_THAT(variants({"", {"A", "Z"}, true, false, false, ""}), SizeIs(6)) << "Z is not declared";
  EXPECT_THAT(variants(always("Z", "")), SizeIs(6));
  EXPECT_THAT(variants(needs("C", {"Z"}, "")), ElementsAre("-", "A", "B"));
}

TEST(KeywordSpace, WhatEmptiesItIsNamed) {
  const KeywordSpace skipped = space_of("#pragma multi_compile A\n#pragma skip_variants A\n");
  EXPECT_EQ(skipped.whole_program().count(), VariantCount(0));
  EXPECT_THAT(texts_of(skipped.whole_program()), IsEmpty());
  EXPECT_EQ(skipped.emptied_by(), "#pragma skip_variants at a.shader:2:1");
  const KeywordSpace pinned =
      space_of("#pragma multi_compile A B\n", {{always("A", "+A"), always("B", "+B")}, {}, {}, {}});
  EXPECT_EQ(pinned.variants(Stage::vertex).count(), VariantCount(0));
  EXPECT_EQ(pinned.emptied_by(), "+B");
  EXPECT_EQ(space_of("#pragma multi_compile _ A\n").emptied_by(), "");
}

TEST(KeywordSpace, MaterialsChooseTheShaderFeatures) {
  const std::string text =
      "#pragma shader_feature A\n#pragma multi_compile _ M\n#pragma shader_feature_fragment B C\n";
  const Narrowing narrowing{{}, {{{"A", "C"}, {"A"}, {"A", "B", "C", "UNKNOWN"}, {}}}, {}, {}};
  const KeywordSpace space = space_of(text, narrowing);
  EXPECT_THAT(texts_of(space.whole_program()), ElementsAre("A C", "A M C", "A B", "A M B", "B", "M B"));
  EXPECT_THAT(texts_of(space.variants(Stage::vertex)), ElementsAre("A", "A M", "-", "M"));
  EXPECT_THAT(texts_of(space_of(text, {{}, std::vector<Keywords>{}, {}, {}}).whole_program()),
              ElementsAre("B", "M B"))
      << "no materials: all off";
}

TEST(KeywordSpace, StereoAndTiersAreAddedOnRequest) {
  const std::string text = "#pragma vertex V\n#pragma hardware_tier_variants metal\n";
  EXPECT_THAT(texts_of(space_of(text, {{}, {}, {"STEREO_INSTANCING_ON"}, "vulkan"}).whole_program()),
              ElementsAre("-", "STEREO_INSTANCING_ON"));
  EXPECT_THAT(texts_of(space_of(text, {{}, {}, {}, "metal"}).whole_program()),
              ElementsAre("UNITY_HARDWARE_TIER1", "UNITY_HARDWARE_TIER2", "UNITY_HARDWARE_TIER3"));
}

TEST(KeywordSpace, OpenGlEsDrawsBothEyesByMultiviewAlone) {
  const Narrowing both{{}, {}, {"STEREO_INSTANCING_ON", "STEREO_MULTIVIEW_ON"}, {}};
  for (const GraphicsApi api : all_graphics_apis) {
    const KeywordSpace space = KeywordSpace(pragmas_of("#pragma vertex V\n"), on_api(both, api));
    if (api == GraphicsApi::gles3) {
      EXPECT_THAT(texts_of(space.whole_program()), ElementsAre("-", "STEREO_MULTIVIEW_ON"));
    } else {
      EXPECT_THAT(texts_of(space.whole_program()),
                  ElementsAre("-", "STEREO_INSTANCING_ON", "STEREO_MULTIVIEW_ON"))
          << renderer_name(api);
    }
  }
}

TEST(KeywordSpace, CountsWithoutEnumerating) {
  const KeywordSpace space = space_of(sets_with_unique_keywords(60, 1));
  EXPECT_EQ(space.whole_program().count(), VariantCount(std::uint64_t{1} << 60U));
  const Keywords last = space.whole_program().at((std::uint64_t{1} << 60U) - 1);
  EXPECT_THAT(last, SizeIs(60));
  EXPECT_THAT(space.whole_program().at(1), ElementsAre("K59_0"));
  EXPECT_THROW(space.whole_program().at(std::uint64_t{1} << 60U), std::out_of_range);
}

TEST(KeywordSpace, CountsSaturate) {
  EXPECT_EQ(space_of(sets_with_unique_keywords(63, 1)).whole_program().count(),
            VariantCount(std::uint64_t{1} << 63U));
  const KeywordSpace many = space_of(sets_with_unique_keywords(400, 3));
  EXPECT_TRUE(many.whole_program().count().saturated());
  EXPECT_THAT(many.whole_program().at(3), ElementsAre("K399_2"));
  const KeywordSpace none =
      space_of("#pragma multi_compile NO\n#pragma skip_variants NO\n" + sets_with_unique_keywords(100, 3));
  EXPECT_EQ(none.whole_program().count(), VariantCount(0)) << "nothing times too many is nothing";
}

TEST(KeywordSpace, CountsWithASetStandingStill) {
  const KeywordSpace space =
      space_of("#pragma multi_compile _ A B\n#pragma multi_compile_fragment C D\n#pragma multi_compile _ E\n",
               {{needs("E", {"A", "B"}, "")}, {}, {}, {}});
  EXPECT_EQ(space.whole_program().count(), VariantCount(10));
  EXPECT_EQ(space.count_without(0, {}), VariantCount(2)) << "neither A nor B, so no E";
  EXPECT_EQ(space.count_without(1, {}), VariantCount(5));
  EXPECT_EQ(space.count_without(1, Stage::vertex), VariantCount(5)) << "not the vertex stage's affair";
  EXPECT_EQ(space.count_without(2, Stage::fragment), VariantCount(6));
}

TEST(KeywordSpace, SetsThatDependOnEachOtherAreBounded) {
  std::string text;
  for (int i = 0; i < 30; ++i) text += "#pragma multi_compile _ SHARED K" + std::to_string(i) + "\n";
  expect_input_error(
      [&] { space_of(text); },
      AllOf(
          HasSubstr("a.shader:1:1: keyword sets that depend on each other span more than 65536 combinations\n"
                    "  pin or exclude some of their keywords; they are declared at\n    a.shader:1:1\n"),
          testing::EndsWith("\n    and 24 more")));
  EXPECT_EQ(space_of(text, {{never("SHARED", "")}, {}, {}, {}}).whole_program().count(),
            VariantCount(1U << 30U));
}

TEST(VariantCount, AddsAndMultipliesWithoutWrapping) {
  const VariantCount limit = VariantCount::at_least_limit();
  const VariantCount big(std::uint64_t{1} << 63U);
  EXPECT_EQ(big * VariantCount(2), limit);
  EXPECT_EQ(big + big, limit);
  EXPECT_EQ(limit * VariantCount(0), VariantCount(0));
  EXPECT_EQ(VariantCount(0) * limit, VariantCount(0));
  EXPECT_EQ(VariantCount(3) * VariantCount(5) + VariantCount(1), VariantCount(16));
  EXPECT_EQ(text_of(VariantCount(1234567)), "1,234,567");
  EXPECT_EQ(text_of(VariantCount(12)), "12");
  EXPECT_EQ(text_of(limit), "more than 18,446,744,073,709,551,614");
}

}  // namespace
}  // namespace penumbra::variants
