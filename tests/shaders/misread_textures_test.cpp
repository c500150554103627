// A texture that a function takes for another kind is refused, though glslang and SPIRV-Tools let it pass.
#include "shaders/misread_textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shader_files.h"
#include "shaders/compile.h"

namespace penumbra::shaders {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kOfEveryKind = R"(
Texture2D Plain; Texture2DArray Layers; TextureCube Cube; TextureCubeArray Cubes; Texture3D Volume; Texture1D Line;
Texture2DMS<float4> Samples; Buffer<float4> Texels; RWTexture2D<float4> Image; RWTexture2DArray<float4> Images;
SamplerState S; SamplerComparisonState C;
float Loaded(Texture2DArray t) { return t.Load(int4(1, 2, 1, 0)).x; }
float Sampled(Texture2DArray t) { return t.SampleLevel(S, float3(0.5, 0.5, 1), 0).x; }
float Gathered(Texture2DArray t) { return t.GatherRed(S, float3(0.5, 0.5, 1)).x; }
float OfCube(TextureCube t) { return t.SampleLevel(S, float3(0, 0, 1), 0).x; }
)";

std::vector<std::string> problems(const std::string& expression) {
  CompileRequest request;
  request.file = "misread.hlsl";
  request.text = compute_shader(expression, kOfEveryKind);
  std::vector<std::string> all;
  for (const hlsl::Diagnostic& diagnostic : compile(request).diagnostics) all.push_back(diagnostic.message);
  return all;
}

TEST(MisreadTextures, APlainTextureIsNoArray) {
  const auto said = ElementsAre(HasSubstr("'Plain' is read with 3 coordinates and has 2"));
  EXPECT_THAT(problems("Loaded(Plain)"), said);
  EXPECT_THAT(problems("Sampled(Plain)"), said);
  EXPECT_THAT(problems("Gathered(Plain)"), said);
}

TEST(MisreadTextures, EachIsSaidOnce) {
  EXPECT_THAT(problems("Loaded(Plain) + Loaded(Plain)"), testing::SizeIs(1));
}

TEST(MisreadTextures, WhatEveryKindTakesIsLetThrough) {
  for (const char* expression :
       {"Loaded(Layers) + Sampled(Layers) + Gathered(Layers)", "OfCube(Cube)", "Plain.Load(int3(1, 2, 0)).x",
        "Plain[id.xy].x", "Plain.SampleLevel(S, float2(0.5, 0.5), 0).x",
        "Plain.GatherRed(S, float2(0.5, 0.5)).x", "Plain.SampleCmpLevelZero(C, float2(0.5, 0.5), 0.5)",

        "Layers.SampleCmpLevelZero(C, float3(0.5, 0.5, 1), 0.5)",
        "Cubes.SampleLevel(S, float4(0, 0, 1, 1), 0).x", "Volume.Load(int4(1, 1, 1, 0)).x",
        "Volume.SampleLevel(S, float3(0, 0, 0), 0).x", "Line.SampleLevel(S, 0.5, 0).x",
        "Samples.Load(int2(1, 1), 0).x", "Texels[id.x].x", "Image[id.xy].x", "Images[uint3(id.xy, 1)].x"}) {
    EXPECT_THAT(problems(expression), IsEmpty()) << expression;
  }
}

// HLSL shortens a vector that is too long for what is called on the texture itself.
TEST(MisreadTextures, AVectorTooLongIsShortened) {
  EXPECT_THAT(problems("Plain.SampleLevel(S, float3(0.5, 0.5, 1), 0).x"), IsEmpty());
}

TEST(MisreadTextures, AnyWordsAreRead) {
  EXPECT_THAT(misread_textures({}), IsEmpty());
  EXPECT_THAT(misread_textures({1, 2, 3, 4, 5, 0xFFFF0000U, 7}), IsEmpty());
}

}  // namespace
}  // namespace penumbra::shaders
