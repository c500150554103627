#include "variants/pragmas.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "variants/program_text.h"

namespace penumbra::variants {
namespace {

using hlsl::Stage;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;
using testing::SizeIs;

TEST(Pragmas, EntryPointsOfEveryStage) {
  const Pragmas pragmas = pragmas_of(
      "#pragma vertex V\n#pragma fragment F\n#pragma geometry G\n#pragma hull H\n#pragma domain D\n");
  EXPECT_THAT(messages_of(pragmas), IsEmpty());
  ASSERT_THAT(pragmas.entry_points, SizeIs(5));
  EXPECT_EQ(pragmas.entry_points[1].stage, Stage::fragment);
  EXPECT_EQ(pragmas.entry_points[1].function, "F");
  EXPECT_EQ(text_of(pragmas.entry_points[1].place), "a.shader:2:1");
}

TEST(Pragmas, KernelsWithTheirMacros) {
  const Pragmas pragmas = pragmas_of("#pragma kernel Blur RADIUS=4 FAST TEXT=\n#pragma kernel Copy\n");
  EXPECT_THAT(messages_of(pragmas), IsEmpty());
  ASSERT_THAT(pragmas.kernels, SizeIs(2));
  EXPECT_THAT(pragmas.kernels[0].defines,
              ElementsAre(Pair("RADIUS", "4"), Pair("FAST", "1"), Pair("TEXT", "")));
  EXPECT_EQ(pragmas.kernels[1].function, "Copy");
}

// The examples are those of the Unity Manual, "Declare shader keywords".
TEST(Pragmas, KeywordSetsAsTheManualHasThem) {
  const Pragmas pragmas = pragmas_of(
      "#pragma shader_feature REFLECTION_TYPE1 REFLECTION_TYPE2 REFLECTION_TYPE3\n"
      "#pragma shader_feature RED GREEN BLUE WHITE\n"
      "#pragma multi_compile _ EXAMPLE_ON\n"
      "#pragma multi_compile ALONE\n"
      "#pragma shader_feature ALONE_TOO\n"
      "#pragma shader_feature __ ___ SPELT\n");
  EXPECT_THAT(labels_of(pragmas),
              ElementsAre("REFLECTION_TYPE1 REFLECTION_TYPE2 REFLECTION_TYPE3", "RED GREEN BLUE WHITE",
                          "_ EXAMPLE_ON", "ALONE", "_ ALONE_TOO", "_ SPELT"));
  EXPECT_EQ(pragmas.keyword_sets[0].kind, KeywordSet::Kind::shader_feature);
  EXPECT_EQ(pragmas.keyword_sets[2].kind, KeywordSet::Kind::multi_compile);
  EXPECT_THAT(messages_of(pragmas),
              ElementsAre("a.shader:6:27: warning: '___' appears twice in one set and counts once"));
}

TEST(Pragmas, SuffixesStandInAnyOrder) {
  const std::tuple<const char*, bool, StageSet> names[] = {
      {"multi_compile", false, StageSet::all()},
      {"multi_compile_local", true, StageSet::all()},
      {"multi_compile_fragment", false, {Stage::fragment}},
      {"shader_feature_local_fragment", true, {Stage::fragment}},
      {"shader_feature_fragment_local", true, {Stage::fragment}},
      {"shader_feature_vertex", false, {Stage::vertex}},
      {"multi_compile_hull", false, {Stage::hull}},
      {"multi_compile_domain_local", true, {Stage::domain}},
      {"multi_compile_geometry", false, {Stage::geometry}},
      {"multi_compile_vertex_fragment", false, {Stage::vertex, Stage::fragment}},
      {"multi_compile_raytracing", false, {}},
  };
  for (const auto& [name, local, stages] : names) {
    const Pragmas pragmas = pragmas_of(std::string("#pragma ") + name + " _ A\n");
    ASSERT_THAT(pragmas.keyword_sets, SizeIs(1)) << name;
    EXPECT_EQ(pragmas.keyword_sets[0].local, local) << name;
    EXPECT_TRUE(pragmas.keyword_sets[0].stages == stages) << name;
    EXPECT_EQ(pragmas.keyword_sets[0].pragma, name);
  }
}

TEST(Pragmas, DynamicKeywordsMakeNoSet) {
  const Pragmas pragmas = pragmas_of(
      "#pragma dynamic_branch _ A B\n#pragma dynamic_branch_local C\n#pragma multi_compile _ A Z\n"
      "#pragma dynamic_branch A\n");
  ASSERT_THAT(pragmas.dynamic_keywords, SizeIs(3));
  EXPECT_EQ(pragmas.dynamic_keywords[1].name, "B");
  EXPECT_FALSE(pragmas.dynamic_keywords[1].local);
  EXPECT_TRUE(pragmas.dynamic_keywords[2].local);
  EXPECT_THAT(labels_of(pragmas), ElementsAre("_ Z"));
  EXPECT_THAT(
      messages_of(pragmas),
      ElementsAre("a.shader:3:1: warning: 'A' is a dynamic_branch keyword, too: it makes no variants"));
}

// The examples are those of the Unity Manual, "Add built-in keyword sets".
TEST(Pragmas, ShortcutsStandForTheManualsKeywords) {
  EXPECT_THAT(labels_of(pragmas_of("#pragma multi_compile_fog\n")),
              ElementsAre("_ FOG_LINEAR FOG_EXP FOG_EXP2"));
  EXPECT_THAT(labels_of(pragmas_of("#pragma multi_compile_instancing\n")), ElementsAre("_ INSTANCING_ON"));
  EXPECT_THAT(labels_of(pragmas_of("#pragma multi_compile_shadowcaster\n")),
              ElementsAre("SHADOWS_DEPTH SHADOWS_CUBE"));
  EXPECT_THAT(labels_of(pragmas_of("#pragma multi_compile_fwdadd\n")),
              ElementsAre("POINT DIRECTIONAL SPOT POINT_COOKIE DIRECTIONAL_COOKIE"));
  EXPECT_THAT(labels_of(pragmas_of("#pragma multi_compile_particles\n")), ElementsAre("_ SOFTPARTICLES_ON"));
}

TEST(Pragmas, ProceduralInstancingIsOneMoreVariant) {
  const Pragmas pragmas = pragmas_of(
      "#pragma multi_compile_instancing\n#pragma instancing_options nolightmap procedural:Setup\n");
  EXPECT_THAT(messages_of(pragmas), IsEmpty());
  EXPECT_EQ(pragmas.procedural_function, "Setup");
  EXPECT_THAT(labels_of(pragmas), ElementsAre("_ INSTANCING_ON PROCEDURAL_INSTANCING_ON"));
}

// The examples are those of the Unity Manual, "Targeting shader models and GPU features".
TEST(Pragmas, TargetsAndRequirementsMayDependOnKeywords) {
  const Pragmas pragmas = pragmas_of(
      "#pragma target 3.5\n#pragma target 4.5 DOTS_INSTANCING_ON OTHER\n"
      "#pragma require integers mrt8 : EXAMPLE_KEYWORD OTHER_KEYWORD\n#pragma require 2darray:K\n");
  EXPECT_THAT(messages_of(pragmas), IsEmpty());
  EXPECT_EQ(shader_target(pragmas, {}), 35);
  EXPECT_EQ(shader_target(pragmas, {"DOTS_INSTANCING_ON"}), 45);
  ASSERT_THAT(pragmas.requirements, SizeIs(2));
  EXPECT_THAT(pragmas.requirements[0].features, ElementsAre("integers", "mrt8"));
  EXPECT_THAT(pragmas.requirements[0].keywords, ElementsAre("EXAMPLE_KEYWORD", "OTHER_KEYWORD"));
  EXPECT_THAT(pragmas.requirements[1].keywords, ElementsAre("K"));
}

TEST(Pragmas, StagesRaiseTheTarget) {
  EXPECT_EQ(shader_target(pragmas_of("#pragma vertex V\n"), {}), 25);
  EXPECT_EQ(shader_target(pragmas_of("#pragma vertex V\n#pragma target 2.0\n"), {"INSTANCING_ON"}), 35);
  EXPECT_EQ(shader_target(pragmas_of("#pragma vertex V\n"), {"PROCEDURAL_INSTANCING_ON"}), 35);
  EXPECT_EQ(shader_target(pragmas_of("#pragma geometry G\n"), {}), 40);
  EXPECT_EQ(shader_target(pragmas_of("#pragma kernel K\n"), {}), 50);
  EXPECT_EQ(shader_target(pragmas_of("#pragma hull H\n#pragma target 5.0\n"), {}), 50);
  EXPECT_EQ(shader_target(pragmas_of("#pragma domain D\n#pragma target es3.1\n"), {}), 46);
}

TEST(Pragmas, RenderersAreChosen) {
  const Pragmas only = pragmas_of("#pragma only_renderers d3d11 vulkan\n");
  EXPECT_TRUE(compiles_for(only, "vulkan"));
  EXPECT_FALSE(compiles_for(only, "metal"));
  const Pragmas without = pragmas_of("#pragma exclude_renderers gles gles3 glcore\n");
  EXPECT_TRUE(compiles_for(without, "metal"));
  EXPECT_FALSE(compiles_for(without, "gles3"));
}

TEST(Pragmas, KnownOnesThatChangeNothingAreSilent) {
  const Pragmas pragmas = pragmas_of(
      "#pragma editor_sync_compilation\n#pragma enable_d3d11_debug_symbols\n#pragma skip_optimizations "
      "d3d11\n"
      "#pragma use_dxc\n#pragma never_use_dxc metal\n#pragma disable_fastmath\n#pragma enable_cbuffer\n"
      "#pragma fragmentoption ARB_precision_hint_fastest\n#pragma glsl\n#pragma prefer_hlslcc gles\n"
      "#pragma once\n#pragma warning (disable : 3568)\n#pragma warning(default: 3568)\n"
      "#pragma pack_matrix(row_major)\n#pragma hardware_tier_variants metal\n");
  EXPECT_THAT(messages_of(pragmas), IsEmpty());
  EXPECT_THAT(pragmas.options, SizeIs(14));
  EXPECT_THAT(pragmas.tier_renderers, ElementsAre("metal"));
}

// The examples are those of the Unity Manual, "include and include_with_pragmas directives in HLSL".
TEST(Pragmas, OnlyFilesIncludedWithPragmasCount) {
  const Files files{{"with.hlsl", "#pragma multi_compile _ WITH\n#include_with_pragmas \"deeper.hlsl\"\n"},
                    {"deeper.hlsl", "#pragma multi_compile _ DEEPER\n"},
                    {"plain.hlsl", "#pragma multi_compile _ PLAIN\n#include_with_pragmas \"with.hlsl\"\n"}};
  const Pragmas pragmas =
      pragmas_of("#include \"plain.hlsl\"\n#include_with_pragmas \"with.hlsl\"\n#pragma vertex V\n", files);
  EXPECT_THAT(labels_of(pragmas), ElementsAre("_ WITH", "_ DEEPER"));
  EXPECT_EQ(text_of(pragmas.keyword_sets[1].place), "deeper.hlsl:1:1");
  EXPECT_THAT(pragmas.files, ElementsAre("a.shader", "with.hlsl", "deeper.hlsl"));
}

TEST(Pragmas, ConditionsAreEvaluated) {
  const std::string text =
      "#define MINE 2\n"
      "#if UNITY_VERSION >= 202220 && defined(SHADER_API_DESKTOP)\n#pragma multi_compile _ NEW\n"
      "#elif MINE == 2\n#pragma multi_compile _ OLD\n"
      "#else\n#pragma multi_compile _ NEITHER\n#endif\n"
      "#ifdef MINE\n#pragma multi_compile _ DEFINED\n#endif\n#undef MINE\n"
      "#ifndef MINE\n# if 0\n#pragma multi_compile _ NEVER\n# else\n#pragma multi_compile _ GONE\n# "
      "endif\n#endif\n";
  EXPECT_THAT(labels_of(pragmas_of(text, {}, {{"UNITY_VERSION", "202230"}, {"SHADER_API_DESKTOP", "1"}})),
              ElementsAre("_ NEW", "_ DEFINED", "_ GONE"));
  EXPECT_THAT(labels_of(pragmas_of(text, {}, {{"UNITY_VERSION", "202130"}})),
              ElementsAre("_ OLD", "_ DEFINED", "_ GONE"));
}

TEST(Pragmas, NothingCountsWithinWhatDoesNotCount) {
  EXPECT_THAT(
      labels_of(pragmas_of("#if 0\n#if 1\n#pragma multi_compile _ A\n#else\n#pragma multi_compile _ B\n"
                           "#endif\n#elif 0\n#else\n#pragma multi_compile _ C\n#endif\n")),
      ElementsAre("_ C"));
  EXPECT_THAT(
      labels_of(pragmas_of("#if 1\n#elif 1\n#pragma multi_compile _ A\n#else\n#pragma multi_compile _ B\n"
                           "#endif\n")),
      IsEmpty());
}

TEST(Pragmas, IncludeGuardsAndOnceHold) {
  const Files files{
      {"guarded.hlsl",
       "#ifndef G\n#define G\n#pragma multi_compile _ A\n"
       "#include_with_pragmas \"guarded.hlsl\"\n#endif\n"},
      {"once.hlsl", "#pragma once\n#pragma multi_compile _ B\n#include_with_pragmas <once.hlsl>\n"}};
  const Pragmas pragmas = pragmas_of(
      "#include_with_pragmas \"guarded.hlsl\"\n#include_with_pragmas \"guarded.hlsl\"\n"
      "#include_with_pragmas \"once.hlsl\"\n#include_with_pragmas \"once.hlsl\"\n",
      files);
  EXPECT_THAT(labels_of(pragmas), ElementsAre("_ A", "_ B"));
  EXPECT_THAT(messages_of(pragmas), IsEmpty());
}

TEST(Pragmas, ABranchEndsWithItsFile) {
  const Files files{{"open.hlsl", "#if 0\n"}, {"closing.hlsl", "#endif\n#pragma multi_compile _ A\n"}};
  EXPECT_THAT(
      labels_of(pragmas_of("#if 1\n#include_with_pragmas \"open.hlsl\"\n"
                           "#include_with_pragmas \"closing.hlsl\"\n#pragma multi_compile _ B\n#endif\n",
                           files)),
      ElementsAre("_ A", "_ B"));
}

}  // namespace
}  // namespace penumbra::variants
