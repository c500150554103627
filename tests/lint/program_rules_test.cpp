// Tests the rules property-type, srp-batcher and unused-keyword, over what several compiled stages declare.
#include "lint/program_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lint/linted_shader.h"

namespace penumbra::lint {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

PassStage pass(const std::string& name, const std::string& declarations, const std::string& expression) {
  return {name,
          hlsl::Stage::fragment,
          {},
          constant_buffers(compiled(fragment("", expression, declarations)).spirv)};
}

std::vector<std::string> all(const std::vector<hlsl::Diagnostic>& findings) {
  std::vector<std::string> text;
  for (const hlsl::Diagnostic& finding : findings) text.push_back(told(finding));
  return text;
}

constexpr const char* material = "cbuffer UnityPerMaterial { float4 _Color; float _Cut; };\n";

TEST(ConstantBuffers, MembersWithTheirBytes) {
  const PassStage stage =
      pass("P", "cbuffer B { float3 _A; float _B; float4x4 _M; float _Arr[3]; float2 _End; };\n", "_A.x");
  ASSERT_EQ(stage.buffers.size(), 1U);
  EXPECT_EQ(stage.buffers[0].name, "B");
  const std::vector<ConstantBufferMember> expected{
      {"_A", 0, 12}, {"_B", 12, 4}, {"_M", 16, 64}, {"_Arr", 80, 36}, {"_End", 128, 8}};
  EXPECT_EQ(stage.buffers[0].members, expected);
  EXPECT_EQ(stage.buffers[0].size, 136U);
}

TEST(PropertyType, AColourThatIsOneNumber) {
  const ShaderToLint shader{
      "S.shader",
      {{"_Color", 4, 9, "Color"},
       {"_Cut", 5, 9, "Range"},
       {"_Wind", 6, 9, "Vector"},
       {"_Tint", 7, 9, "Color"}},
      {pass("Forward", "float _Color; float _Cut; float2 _Wind; half3 _Tint;\n", "_Color * _Cut"),
       pass("Depth", "float4 _Color; half _Wind;\n", "_Color")}};
  EXPECT_THAT(
      all(property_type_findings(shader)),
      ElementsAre(
          "4:9 warning property-type: property '_Color' is a Color, and pass 'Forward' declares it as one "
          "number, which gets its first component: declare it float4, or make the property a Float",
          testing::StartsWith("6:9 warning property-type: property '_Wind' is a Vector, and pass 'Depth'")));
}

TEST(SrpBatcher, PropertiesInTheMaterialsBuffer) {
  EXPECT_THAT(
      srp_batcher_findings({"S.shader",
                            {{"_Color", 4, 9}, {"_Cut", 5, 9}},
                            {pass("Forward", material, "_Color * _Cut"), pass("Depth", material, "_Cut")}}),
      IsEmpty());
}

TEST(SrpBatcher, APropertyOutsideOfEveryBuffer) {
  EXPECT_THAT(
      all(srp_batcher_findings(
          {"S.shader",
           {{"_Color", 4, 9}, {"_Cut", 5, 9}},
           {pass("Forward", "cbuffer UnityPerMaterial { float4 _Color; };\nfloat _Cut;\n",
                 "_Color * _Cut")}})),
      ElementsAre("5:9 warning srp-batcher: material property '_Cut' is declared outside of every constant "
                  "buffer in pass 'Forward' (fragment); the SRP Batcher needs it in UnityPerMaterial"));
}

TEST(SrpBatcher, APropertyInAnotherBuffer) {
  EXPECT_THAT(
      all(srp_batcher_findings(
          {"S.shader", {{"_Cut", 5, 9}}, {pass("Forward", "cbuffer Mine { float _Cut; };\n", "_Cut")}})),
      ElementsAre(
          "5:9 warning srp-batcher: material property '_Cut' is declared in constant buffer 'Mine' in "
          "pass 'Forward' (fragment); the SRP Batcher needs it in UnityPerMaterial"));
}

TEST(SrpBatcher, GlobalsThatAreNoPropertiesMayStandAnywhere) {
  EXPECT_THAT(
      srp_batcher_findings({"S.shader",
                            {{"_Color", 4, 9}},
                            {pass("Forward", std::string(material) + "float _Wind;\n", "_Color * _Wind")}}),
      IsEmpty());
}

TEST(SrpBatcher, LayoutsThatDifferBetweenPasses) {
  EXPECT_THAT(
      all(srp_batcher_findings(
          {"S.shader",
           {},
           {pass("Forward", material, "_Color"),
            pass("Depth", "cbuffer UnityPerMaterial { float _Cut; float4 _Color; };\n", "_Cut")}})),
      ElementsAre(
          "0 warning srp-batcher: UnityPerMaterial differs between pass 'Forward' (fragment) and pass "
          "'Depth' (fragment): '_Color' at byte 0 of 16 bytes against '_Cut' at byte 0 of 4 bytes; "
          "the SRP Batcher needs one layout in all passes"));
  EXPECT_THAT(all(srp_batcher_findings(
                  {"S.shader",
                   {},
                   {pass("Forward", material, "_Color"),
                    pass("Depth", "cbuffer UnityPerMaterial { float4 _Color; };\n", "_Color")}})),
              ElementsAre(testing::HasSubstr("'_Cut' is only in the first")));
}

TEST(SrpBatcher, APassWithoutTheBufferIsNoLayout) {
  EXPECT_THAT(
      srp_batcher_findings({"S.shader", {}, {pass("Forward", material, "_Color"), pass("Meta", "", "1")}}),
      IsEmpty());
}

ProgramKeywords program(std::vector<VariantText> variants) {
  return {
      "S.shader", "pass 'Forward' (fragment)", {{"_FOG", 12, 25}, {"_DEAD", 13, 25}}, std::move(variants)};
}

TEST(UnusedKeyword, OneThatNeverChangesAnything) {
  EXPECT_THAT(
      all(unused_keyword_findings(
          program({{{}, "a"}, {{"_FOG"}, "b"}, {{"_DEAD"}, "a"}, {{"_DEAD", "_FOG"}, "b"}}))),
      ElementsAre(
          "13:25 warning unused-keyword: keyword '_DEAD' changes nothing in pass 'Forward' (fragment) "
          "(2 pairs of variants compared), but doubles how many are compiled"));
}

TEST(UnusedKeyword, OneThatChangesASinglePairIsUsed) {
  EXPECT_THAT(unused_keyword_findings(
                  program({{{}, "a"}, {{"_FOG"}, "b"}, {{"_DEAD"}, "a"}, {{"_DEAD", "_FOG"}, "c"}})),
              IsEmpty());
}

TEST(UnusedKeyword, OneThatWasNeverToggledAloneIsNotJudged) {
  EXPECT_THAT(unused_keyword_findings(program({{{}, "a"}, {{"_DEAD", "_FOG"}, "a"}})), IsEmpty());
}

}  // namespace
}  // namespace penumbra::lint
