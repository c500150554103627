// Stages of one program that do not fit are errors, in every combination of their keywords.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hlsl/source_text.h"
#include "validation/report_merge.h"
#include "validation/shader_sources.h"
#include "validation/validate_techniques.h"
#include "validation/validation_units.h"

namespace penumbra::validation {

using shaders::ShaderFiles;

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr const char* position = "float4 p : SV_Position; ";

class StageLinkage : public testing::Test {
 protected:
  // The text has the members `outputs` in Vert's struct and `inputs` in Frag's; Frag adds all of `read`.
  static std::string stages(const std::string& outputs, const std::string& inputs, const std::string& read) {
    return "struct Out { " + outputs + "};\nstruct In { " + inputs +
           "};\nOut Vert(float4 v : POSITION) { return (Out)v.x; }\n"
           "float4 Frag(In i) : SV_Target { return " +
           read + "; }\n";
  }

  ValidationRequest request(const std::string& code, const std::string& pragmas = "",
                            variants::GraphicsApi api = variants::GraphicsApi::d3d11) {
    files_.write("T.shader",
                 "Shader \"T\" { SubShader { Pass { Name \"Forward\"\nHLSLPROGRAM\n#pragma vertex Vert\n"
                 "#pragma fragment Frag\n" +
                     pragmas + "\n" + code + "ENDHLSL\n} } }\n");
    SourceOptions options;
    variants::Platform platform;
    platform.api = api;
    options.platforms = {{platform, {"spirv"}}};
    ShaderSources sources(options);
    sources.add({files_.path("T.shader"), "T.shader"});
    ValidationRequest request;
    request.targets = {"spirv"};
    request.units = sources.units();
    request.records = sources.records();
    return request;
  }

  static std::vector<std::string> errors(const ValidationReport& report) {
    std::vector<std::string> list;
    for (const VariantRecord& record : report.records)
      for (const hlsl::Diagnostic& said : record.diagnostics) {
        EXPECT_EQ(record.status, VariantStatus::failed);
        list.push_back(std::to_string(said.line) + ":" + std::to_string(said.column) + " " +
                       said.message.substr(0, said.message.find(" (/")));
      }
    return list;
  }

  std::vector<std::string> errors(const std::string& code, const std::string& pragmas = "") {
    return errors(validate(request(code, pragmas)));
  }

  ShaderFiles files_;
};

TEST_F(StageLinkage, WhatNobodyWritesCannotBeRead) {
  EXPECT_THAT(
      errors(stages(position, std::string(position) + "float3 n : Normal; ", "i.n.xyzz")),
      ElementsAre(
          "7:48 the fragment program reads 'NORMAL0', which the vertex program 'Vert' does not write"));
}

TEST_F(StageLinkage, TypesAndComponentsAreThoseOfTheWriter) {
  EXPECT_THAT(
      errors(stages(std::string(position) + "float2 uv : TEXCOORD0; int id : ID; ",
                    "float4 uv : TEXCOORD0; nointerpolation uint id : ID; ", "i.uv + i.id")),
      ElementsAre(
          "7:25 'TEXCOORD0' is float4 in the fragment program, but the vertex program 'Vert' writes float2",
          "7:62 'ID0' is uint in the fragment program, but the vertex program 'Vert' writes int"));
}

TEST_F(StageLinkage, ArraysAndMatricesTakeConsecutiveSemantics) {
  EXPECT_THAT(
      errors(stages(std::string(position) + "float4 a : A0; float4 b : A1; float4 m[2] : M; ",
                    "float4 a[2] : A; float4 m[3] : M; ", "i.a[0] + i.a[1] + i.m[0] + i.m[2]")),
      ElementsAre("7:44 the fragment program reads 'M2', which the vertex program 'Vert' does not write"));
}

TEST_F(StageLinkage, TheInstanceIsWrittenForTheFragmentProgram) {
  const std::string input = "uint id : SV_InstanceID; ";
  EXPECT_THAT(
      errors(stages(position, input, "i.id")),
      ElementsAre("7:23 the fragment program reads 'SV_INSTANCEID', which the vertex program 'Vert' does not "
                  "write"));
  EXPECT_THAT(errors(stages(position + input, input, "i.id")), IsEmpty());
  EXPECT_THAT(errors(stages(position, input, "1")), IsEmpty()) << "not read";
}

TEST_F(StageLinkage, FittingStagesAreSilent) {
  EXPECT_THAT(
      errors(stages(std::string(position) + "float4 uv : texcoord; float4x4 m : MAT; float4 c : COLOR0; ",
                    "float2 uv : TEXCOORD0; float4x4 m : MAT; float4 c : COLOR; float unread : UNREAD; "
                    "bool face : SV_IsFrontFace; ",
                    "i.uv.xyxy + i.m[1] + i.c + i.face")),
      IsEmpty());
  EXPECT_THAT(errors(stages(position, "float4 p : SV_Position; float face : VFACE; ", "i.p + i.face")),
              IsEmpty());
}

TEST_F(StageLinkage, APositionIsWrittenBeforeTheRasteriser) {
  EXPECT_THAT(errors(stages("float4 p : POSITION; ", "float4 p : VPOS; ", "i.p")), IsEmpty())
      << "Direct3D 9's names";
  EXPECT_THAT(errors(stages("float4 p : POSITION; ", "float4 p : POSITION; ", "1")), IsEmpty()) << "not read";
  EXPECT_THAT(
      errors(stages("float4 p : POSITION; ", "float4 p : POSITION; ", "i.p")),
      ElementsAre(
          "7:24 the fragment program reads 'POSITION0', which the vertex program 'Vert' does not write"));
  EXPECT_THAT(errors(stages("float4 p : COLOR; ", "float unread : UNREAD; ", "1")),
              ElementsAre("3:1 the vertex program 'Vert' writes no SV_Position, so nothing is drawn"));
}

// Only the last stage before the fragment program needs a position, and only what that one writes can be
// read.
TEST_F(StageLinkage, EachStageIsComparedWithTheOneBeforeIt) {
  const std::string geometry =
      "struct V { float4 world : WORLD; };\nstruct G { float4 p : SV_Position; };\n"
      "V Vert(float4 v : POSITION) { V o; o.world = v; return o; }\n"
      "[maxvertexcount(1)] void Geom(point V v[1], inout PointStream<G> s) { G g; g.p = v[0].world; "
      "s.Append(g); }\n";
  EXPECT_THAT(errors(geometry + "float4 Frag() : SV_Target { return 1; }\n", "#pragma geometry Geom"),
              IsEmpty());
  EXPECT_THAT(
      errors(geometry + "float4 Frag(float4 w : WORLD) : SV_Target { return w; }\n", "#pragma geometry Geom"),
      ElementsAre(
          "10:24 the fragment program reads 'WORLD0', which the geometry program 'Geom' does not write"));
}

// POSITION is Direct3D 9's name of SV_Position only where the vertex program's output goes to the rasterizer.
TEST_F(StageLinkage, AGeometryProgramReadsThePositionByItsName) {
  EXPECT_THAT(
      errors("struct V { float4 p : POSITION; };\nstruct G { float4 p : SV_Position; };\nV Vert(float4 v : "
             "POSITION) { V o; o.p = v; return o; }\n"
             "[maxvertexcount(1)] void Geom(point V v[1], inout PointStream<G> s) { G g; g.p = v[0].p; "
             "s.Append(g); }\nfloat4 Frag() : SV_Target { return 1; }\n",
             "#pragma geometry Geom"),
      IsEmpty());
}

// FXC's compatibility mode reads `inout float4 p : POSITION` as an attribute and the position that is drawn.
TEST_F(StageLinkage, AnInoutPositionIsWritten) {
  EXPECT_THAT(errors("void Vert(inout float4 p : POSITION, inout float2 u : TEXCOORD0) { p.z = 0.5; }\n"
                     "float4 Frag(float2 u : TEXCOORD0) : SV_Target { return u.xyxy; }\n"),
              IsEmpty());
}

// The lines of messages are those of the whole shader.
const std::string keyword_stages =
    hlsl::read_source(PENUMBRA_SOURCE_DIR "/tests/validation/keyword_stages.hlsl").text;
constexpr const char* keyword_pragmas =
    "#pragma multi_compile _ LIT\n#pragma multi_compile_vertex _ WAVES\n#pragma multi_compile_fragment _ FOG";

TEST_F(StageLinkage, KeywordsOfBothStagesAreOnInBoth) {
  const std::string expected =
      "17:43 the fragment program reads 'ID0', which the vertex program 'Vert' with WAVES does not write";
  EXPECT_THAT(errors(keyword_stages, keyword_pragmas), ElementsAre(expected, expected))
      << "with and without LIT";
}

// There the vertex program is compiled with FOG and the fragment program with WAVES, too.
TEST_F(StageLinkage, OpenGLAndVulkanHaveNoStageSpecificKeywords) {
  for (const variants::GraphicsApi api : {variants::GraphicsApi::vulkan, variants::GraphicsApi::gles3})
    EXPECT_THAT(errors(validate(request(keyword_stages, keyword_pragmas, api))), IsEmpty());
  EXPECT_THAT(errors(validate(request(keyword_stages, "#pragma multi_compile _ FOG WAVES\n\n",
                                      variants::GraphicsApi::vulkan))),
              testing::SizeIs(1))
      << "with WAVES, which is no stage's own";
}

// A shard compiles what it lacks for the comparison, so that the shards find what the whole run finds.
TEST_F(StageLinkage, ShardsFindWhatTheWholeRunFinds) {
  ValidationRequest request = this->request(keyword_stages, keyword_pragmas);
  const ValidationReport whole = validate(request);
  for (const unsigned count : {2U, 5U}) {
    std::vector<NamedReport> parts;
    for (unsigned index = 1; index <= count; ++index) {
      request.engine.shard = {index, count};
      parts.push_back({std::to_string(index), validate(request)});
    }
    EXPECT_EQ(errors(merge_reports(std::move(parts))), errors(whole)) << count;
  }
}

TEST_F(StageLinkage, TheCacheKeepsSignatures) {
  ValidationRequest request = this->request(keyword_stages, keyword_pragmas);
  const std::vector<std::string> expected = errors(validate(request));
  request.engine.cache = files_.path("cache");
  for (int i = 0; i < 2; ++i) {
    const ValidationReport report = validate(request);
    EXPECT_EQ(errors(report), expected);
    EXPECT_EQ(report.records.at(0).cached, i > 0);
  }
}

TEST_F(StageLinkage, NoKeywordsAreMinimalForAnErrorOfTwoStages) {
  ValidationRequest request = this->request(keyword_stages, keyword_pragmas);
  request.minimise = true;
  EXPECT_THAT(validate(request).minimal, IsEmpty());
}

}  // namespace
}  // namespace penumbra::validation
