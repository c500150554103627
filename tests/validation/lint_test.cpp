// Tests what lint adds to a validation: messages of variants, messages of whole shaders, and when they stay
// silent.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "validation/program_lint.h"
#include "validation/shader_sources.h"
#include "validation/unit_lint.h"
#include "validation/validate_techniques.h"
#include "validation/validation_units.h"

namespace penumbra::validation {

using shaders::ShaderFiles;

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* divergent =
    "float4 Main(float2 uv : TEXCOORD0) : SV_Target\n{\n    if (uv.x > 0.5)\n        uv.x += ddx(uv.y);\n"
    "    return uv.x;\n}\n";

// The text "file name:line rule" of every message that a rule gave.
std::vector<std::string> found(const ValidationReport& report) {
  std::vector<std::string> list;
  for (const VariantRecord& record : report.records)
    for (const hlsl::Diagnostic& said : record.diagnostics)
      if (!said.rule.empty())
        list.push_back(std::filesystem::path(said.file).filename().string() + ":" +
                       std::to_string(said.line) + " " + said.rule);
  return list;
}

class UnitLint : public testing::Test {
 protected:
  ValidationRequest request(const std::string& text) {
    files_.write("f.hlsl", text);
    ValidationRequest request;
    request.files = {{files_.path("f.hlsl"), "Main", hlsl::Stage::fragment, {{}}}};
    request.targets = {"spirv"};
    request.lint.wanted = true;
    return request;
  }

  ShaderFiles files_;
};

TEST_F(UnitLint, FindsInTheVariantsThatHaveIt) {
  ValidationRequest two = request(
      "float4 Main(float2 uv : TEXCOORD0) : SV_Target\n{\n#ifdef SHARP\n    if (uv.x > 0.5)\n        uv.x += "
      "ddx(uv.y);\n#endif\n    return uv.x;\n}\n");
  two.files[0].keyword_sets = {{}, {"SHARP"}};
  const ValidationReport report = validate(two);
  EXPECT_THAT(report.records.at(0).diagnostics, IsEmpty());
  ASSERT_THAT(report.records.at(1).diagnostics, SizeIs(1));
  EXPECT_EQ(report.records.at(1).diagnostics[0].line, 5);
  EXPECT_EQ(report.records.at(1).diagnostics[0].source_line, "        uv.x += ddx(uv.y);");
  EXPECT_EQ(report.records.at(1).status, VariantStatus::passed) << "a warning";
  EXPECT_THAT(report.rules, testing::Contains(testing::Key("divergent-derivative")));
}

TEST_F(UnitLint, WhatUnityRejectsFailsTheVariant) {
  const ValidationReport report = validate(request(
      "Texture2D _Map; SamplerState _Other;\nfloat4 Main() : SV_Target { return _Map.Sample(_Other, 0.5); "
      "}\n"));
  EXPECT_THAT(found(report), ElementsAre("f.hlsl:1 sampler-name"));
  EXPECT_EQ(report.records.at(0).status, VariantStatus::failed) << report_text(report);
}

TEST_F(UnitLint, IsSilentWhereItIsNotWantedAndForRulesLeftOut) {
  ValidationRequest unwanted = request(divergent);
  unwanted.lint.wanted = false;
  EXPECT_THAT(found(validate(unwanted)), IsEmpty());
  EXPECT_THAT(validate(unwanted).rules, IsEmpty());
  ValidationRequest left_out = request(divergent);
  EXPECT_THAT(found(validate(left_out)), ElementsAre("f.hlsl:4 divergent-derivative"));
  left_out.lint.left_out = {"divergent-derivative"};
  EXPECT_THAT(found(validate(left_out)), IsEmpty());
}

TEST_F(UnitLint, ChangesNoModule) {
  ValidationRequest with = request(divergent);
  ValidationRequest without = with;
  without.lint.wanted = false;
  EXPECT_EQ(validate(with).records.at(0).module, validate(without).records.at(0).module);
}

// A comment is no part of the text that answers are kept by.
TEST_F(UnitLint, CommentsThatSilenceAreSeenThroughTheCache) {
  ValidationRequest kept = request(divergent);
  kept.engine.cache = files_.path("cache");
  std::string silenced = divergent;
  silenced.insert(silenced.find("(uv.y);") + 7, " // penumbra-lint: disable=divergent-derivative");
  for (int i = 0; i < 2; ++i) {
    files_.write("f.hlsl", divergent);
    EXPECT_THAT(found(validate(kept)), SizeIs(1)) << i;
    files_.write("f.hlsl", silenced);
    EXPECT_THAT(found(validate(kept)), IsEmpty()) << i;
    EXPECT_TRUE(validate(kept).records.at(0).cached);
  }
}

TEST_F(UnitLint, ACrashInItLosesItsMessagesAlone) {
  files_.write("f.hlsl", divergent);
  CompileUnit unit = misbehaving(fragment_unit(files_.path("f.hlsl")), "crash@lint");
  unit.lint.wanted = true;
  unit.targets = {"spirv"};
  EngineOptions options;
  options.worker_arguments = {misbehaving_mode};
  options.keep = files_.path("kept");
  options.cache = files_.path("cache");
  for (int i = 0; i < 2; ++i) {
    const UnitResult result = run_units({unit}, options).results.at(0);
    EXPECT_EQ(result.targets[0].status, VariantStatus::passed) << i;
    ASSERT_THAT(result.targets[0].diagnostics, SizeIs(1)) << i;
    EXPECT_EQ(result.targets[0].diagnostics[0].rule, "not-checked");
    EXPECT_THAT(result.targets[0].diagnostics[0].message, HasSubstr("lint crashed with SIGABRT"));
    EXPECT_TRUE(std::filesystem::exists(result.targets[0].reproduction));
  }
}

class ProgramLint : public testing::Test {
 protected:
  static std::string shader(const std::string& tags, const std::string& code) {
    return "Shader \"T\"\n{\nProperties\n{\n_Color (\"\", Color) = (1,1,1,1)\n_Cut (\"\", Float) = 0\n"
           "[PerRendererData] _Own (\"\", Float) = 0\n}\nSubShader\n{\nTags { " +
           tags + " }\nPass\n{\nName \"Forward\"\nHLSLPROGRAM\n#pragma vertex Vert\n#pragma fragment Frag\n" +
           code + "\nENDHLSL\n}\n}\n}\n";
  }

  ValidationRequest request(const std::string& text, SourceOptions options = {}) {
    files_.write("T.shader", text);
    variants::Platform vulkan;
    vulkan.api = variants::GraphicsApi::vulkan;
    options.platforms = {{vulkan, {"spirv"}}};
    options.lint.wanted = true;
    ShaderSources sources(options);
    sources.add({files_.path("T.shader"), "T.shader"});
    ValidationRequest request;
    request.targets = {"spirv"};
    request.units = sources.units();
    request.records = sources.records();
    request.programs = sources.to_lint();
    request.lint.wanted = true;
    return request;
  }

  ShaderFiles files_;
};

constexpr const char* stages =
    "#pragma multi_compile _ LIVE\n#pragma multi_compile _ DEAD\n"
    "cbuffer UnityPerMaterial { float4 _Color; };\n"
    "float4 Vert(float3 p : POSITION) : SV_Position { return float4(p, 1); }\n"
    "float4 Frag() : SV_Target\n{\n#ifdef LIVE\nreturn 1;\n#endif\nreturn _Color;\n}";

TEST_F(ProgramLint, AKeywordThatChangesNoStageIsUnused) {
  const ValidationReport report = validate(request(shader("", stages)));
  EXPECT_THAT(found(report), ElementsAre("T.shader:19 unused-keyword"));
  EXPECT_EQ(report.records.back().target, whole_source);
  EXPECT_THAT(report.records.back().diagnostics.at(0).message, HasSubstr("'DEAD'"));
  EXPECT_EQ(report.records.back().diagnostics.at(0).source_line, "#pragma multi_compile _ DEAD");
  EXPECT_THAT(report_text(report), HasSubstr("8 variants for 1 target: 8 results"))
      << "messages are no results";
}

TEST_F(ProgramLint, KeywordsAreJudgedOnlyWhereAllVariantsAre) {
  SourceOptions sampled;
  sampled.sample = 3;
  EXPECT_THAT(found(validate(request(shader("", stages), sampled))), IsEmpty());
  ValidationRequest sharded = request(shader("", stages));
  sharded.engine.shard = {1, 2};
  EXPECT_THAT(found(validate(sharded)), IsEmpty());
}

TEST_F(ProgramLint, AProgramThatDoesNotCompileHasNoUnusedKeywords) {
  std::string broken = stages;
  broken.replace(broken.find("return 1;"), 9, "return missing;");
  EXPECT_THAT(found(validate(request(shader("", broken)))), IsEmpty());
}

TEST_F(ProgramLint, ACommentAtThePragmaSilences) {
  std::string silenced = stages;
  silenced.replace(silenced.find("_ DEAD"), 6, "_ DEAD // penumbra-lint: disable=unused-keyword");
  EXPECT_THAT(found(validate(request(shader("", silenced)))), IsEmpty());
}

constexpr const char* outside =
    "cbuffer UnityPerMaterial { float4 _Color; };\nfloat _Cut;\nfloat _Own;\n"
    "float4 Vert(float3 p : POSITION) : SV_Position { return float4(p, 1); }\n"
    "float4 Frag() : SV_Target { return _Color * _Cut * _Own; }";

TEST_F(ProgramLint, PropertiesBelongIntoTheMaterialsBuffer) {
  EXPECT_THAT(found(validate(request(shader("", outside)))), ElementsAre("T.shader:6 srp-batcher"));
}

TEST_F(ProgramLint, TypesOfPropertiesAreComparedInEveryPipeline) {
  std::string number = stages;
  number.replace(number.find("cbuffer"), number.find('\n', number.find("cbuffer")) - number.find("cbuffer"),
                 "float _Color;");
  EXPECT_THAT(found(validate(request(shader("", number)))),
              ElementsAre("T.shader:19 unused-keyword", "T.shader:5 property-type"));
}

// URP's choice of a cascade, in brief.
constexpr const char* cascades =
    "cbuffer MainLightShadows { float4x4 _MainLightWorldToShadow[5]; float4 _CascadeShadowSplitSpheres0; };\n"
    "Texture2D _Map; SamplerComparisonState sampler_LinearClampCompare;\n"
    "float4 ShadowCoord(float3 p) { float3 away = p - _CascadeShadowSplitSpheres0.xyz;\n"
    "return mul(_MainLightWorldToShadow[dot(away, away) < 4 ? 0 : 1], float4(p, 1)); }\n"
    "float Shadow(float4 at) { float light = _Map.SampleCmpLevelZero(sampler_LinearClampCompare, at.xy, "
    "at.z);\n"
    "return at.z >= 1 ? 1 : light; }\n"
    "struct V { float4 p : SV_Position;\nfloat4 value : TEXCOORD0;\n};\n";

TEST_F(ProgramLint, AShadowCoordinateOfCascadesIsNotInterpolated) {
  const auto with = [&](const std::string& value, const std::string& read, const std::string& comment = "") {
    std::string code = cascades;
    code.insert(code.find("TEXCOORD0;") + 10, comment);
    return validate(request(
        shader("", code + "V Vert(float3 p : POSITION) { V v; v.p = float4(p, 1); v.value = " + value +
                       "; return v; }\nfloat4 Frag(V v) : SV_Target { return " + read + "; }")));
  };
  const ValidationReport report = with("ShadowCoord(p)", "Shadow(v.value)");
  ASSERT_THAT(found(report), ElementsAre("T.shader:25 interpolated-cascade"));
  for (const VariantRecord& record : report.records) EXPECT_EQ(record.status, VariantStatus::passed);
  EXPECT_THAT(report_text(report),
              HasSubstr("T.shader:25:16: warning: 'TEXCOORD0' is a shadow coordinate that the vertex program "
                        "'Vert' calculates with cascades"));
  EXPECT_THAT(
      found(with("ShadowCoord(p)", "Shadow(v.value)", "  // penumbra-lint: disable=interpolated-cascade")),
      IsEmpty());
  EXPECT_THAT(found(with("ShadowCoord(p)", "Shadow(ShadowCoord(v.p.xyz))")), IsEmpty()) << "not read";
  EXPECT_THAT(found(with("Shadow(ShadowCoord(p))", "v.value")), IsEmpty()) << "light";
  EXPECT_THAT(found(with("mul(_MainLightWorldToShadow[0], float4(p, 1))", "Shadow(v.value)")), IsEmpty())
      << "one cascade";
}

TEST_F(UnitLint, ConditionsAreSeenThroughTheCache) {
  ValidationRequest kept = request(divergent);
  kept.engine.cache = files_.path("cache");
  for (const char* version : {"60010000", "600010", "60010000"}) {
    files_.write("f.hlsl", std::string("#if UNITY_VERSION >= ") + version +
                               "\n#endif\nfloat4 Main() : SV_Target { return 1; }\n");
    EXPECT_THAT(found(validate(kept)), SizeIs(std::string(version).size() == 8 ? 0 : 1)) << version;
  }
}

TEST_F(ProgramLint, TheBatcherIsForScriptablePipelines) {
  std::string no_buffer = outside;
  no_buffer.replace(0, no_buffer.find('\n'), "float4 _Color;");
  EXPECT_THAT(found(validate(request(shader("", no_buffer)))), IsEmpty());
  EXPECT_THAT(found(validate(request(shader("\"RenderPipeline\" = \"UniversalPipeline\"", no_buffer)))),
              ElementsAre("T.shader:5 srp-batcher", "T.shader:6 srp-batcher"));
}

TEST_F(ProgramLint, InstancedVariantsAreNotBatched) {
  const std::string instanced =
      "#pragma multi_compile _ INSTANCING_ON\ncbuffer UnityPerMaterial { float4 _Color;\n#ifndef "
      "INSTANCING_ON\n"
      "float _Cut;\n#endif\n};\n#ifdef INSTANCING_ON\nfloat _Cut;\n#endif\n"
      "float4 Vert(float3 p : POSITION) : SV_Position { return float4(p, 1); }\n"
      "float4 Frag() : SV_Target { return _Color * _Cut; }";
  EXPECT_THAT(found(validate(request(shader("", instanced)))), IsEmpty());
  std::string other = instanced;
  for (std::size_t at; (at = other.find("INSTANCING_ON")) != std::string::npos;)
    other.replace(at, 13, "OTHER");
  EXPECT_THAT(found(validate(request(shader("", other)))),
              ElementsAre("T.shader:6 srp-batcher", "T.shader:0 srp-batcher"));
}

}  // namespace
}  // namespace penumbra::validation
