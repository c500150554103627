// A user's own shadow function: a small pipeline in URP's manner, and every way an adapter is refused.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "input/input_error_matcher.h"
#include "reference/scratch_folder.h"
#include "resolve/resolve.h"
#include "resolve/synthetic_frame.h"
#include "resolve/test_device.h"

namespace penumbra::resolve {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing_frames::FrameSetup;
using testing_frames::TilePoint;

constexpr int kTexels = 64;

// The macros of one graphics API, where a pipeline keeps them.
constexpr const char* kApi = R"(
#define TEXTURE2D_SHADOW(textureName) Texture2D textureName
#define SAMPLER_CMP(samplerName) SamplerComparisonState samplerName
#define TEXTURE2D_SHADOW_PARAM(textureName, samplerName) Texture2D textureName, SamplerComparisonState samplerName
#define TEXTURE2D_SHADOW_ARGS(textureName, samplerName) textureName, samplerName
#define SAMPLE_TEXTURE2D_SHADOW(textureName, samplerName, coord3) \
    textureName.SampleCmpLevelZero(samplerName, (coord3).xy, (coord3).z)
)";

// Core functions, with half and float twins made by one macro.
constexpr const char* kCommon = R"(
#ifndef UNITY_COMMON_INCLUDED
#define UNITY_COMMON_INCLUDED
#define real float
#include "Packages/test.core/ShaderLibrary/API/Vulkan.hlsl"
#define TWINS(type) type Mean3(type a, type b, type c) { return (a + b + c) / type(3.0); }
TWINS(half)
TWINS(float)
#endif
)";

// The mean of nine comparisons, one texel apart.
constexpr const char* kShadows = R"(
#include "Packages/test.core/ShaderLibrary/Common.hlsl"
TEXTURE2D_SHADOW(_MainLightShadowmapTexture);
SAMPLER_CMP(sampler_LinearClampCompare);
float4x4 _MainLightWorldToShadow[5];
float4 _MainLightShadowmapSize;
float4 _NobodyProvidesThis;
float4 _NobodyReadsThis;
half Row(TEXTURE2D_SHADOW_PARAM(map, sampler_map), float3 at, half y)
{
    const float2 texel = _MainLightShadowmapSize.xy;
    return Mean3(SAMPLE_TEXTURE2D_SHADOW(map, sampler_map, at + float3(float2(-1.0, y) * texel, 0.0)),
                 SAMPLE_TEXTURE2D_SHADOW(map, sampler_map, at + float3(float2(0.0, y) * texel, 0.0)),
                 SAMPLE_TEXTURE2D_SHADOW(map, sampler_map, at + float3(float2(1.0, y) * texel, 0.0)));
}
float MeanOfNine(float3 positionWS)
{
    const float3 at = mul(_MainLightWorldToShadow[0], float4(positionWS, 1.0)).xyz;
    return Mean3(Row(TEXTURE2D_SHADOW_ARGS(_MainLightShadowmapTexture, sampler_LinearClampCompare), at, -1.0),
                 Row(TEXTURE2D_SHADOW_ARGS(_MainLightShadowmapTexture, sampler_LinearClampCompare), at, 0.0),
                 Row(TEXTURE2D_SHADOW_ARGS(_MainLightShadowmapTexture, sampler_LinearClampCompare), at, 1.0)) +
           _NobodyProvidesThis.x;
}
)";

constexpr const char* kAdapterOfNine = R"(
#include "Packages/test.pipeline/ShaderLibrary/Shadows.hlsl"
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel) { return MeanOfNine(positionWS); }
)";

class AdapterTest : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    const std::filesystem::path file = folder_.path() / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
    return file;
  }

  Adapter adapter(const std::string& text) const {
    Adapter adapter;
    adapter.name = "mine";
    adapter.file = write("Mine.hlsl", text);
    return adapter;
  }

  Adapter adapter_of_nine() const {
    write("core/ShaderLibrary/API/Vulkan.hlsl", kApi);
    write("core/ShaderLibrary/Common.hlsl", kCommon);
    write("pipeline/ShaderLibrary/Shadows.hlsl", kShadows);
    Adapter nine = adapter(kAdapterOfNine);
    nine.package_roots = {{"test.core", folder_.path() / "core"},
                          {"test.pipeline", folder_.path() / "pipeline"}};
    return nine;
  }

  // Columns left of the middle block; one receiver in the centre of each of the given texels of a row.
  static scene::Frame half_plane(const std::vector<int>& texels, bool reversed_z) {
    FrameSetup setup;
    setup.shadows.cascades = 1;
    setup.shadows.resolution = kTexels;
    setup.shadows.reversed_z = reversed_z;
    const auto map = [=](double u, double, int) {
      return u < 0.5 ? testing_frames::nearest_depth(reversed_z) : testing_frames::farthest_depth(reversed_z);
    };
    std::vector<TilePoint> receivers;
    for (const int texel : texels) receivers.emplace_back((texel + 0.5) / kTexels, 0.5 + 0.5 / kTexels, 0.5);
    return testing_frames::make_frame(setup, map, receivers, static_cast<int>(texels.size()));
  }

  static ResolveResult run(const ShadowShader& shader, const scene::Frame& frame) {
    const FrameOnDevice on_device(test_device(), frame);
    return Resolver(test_device(), compile(shader))
        .resolve(on_device, {.noise_seeds = 1, .timing_repeats = 0});
  }

  void expect_refused(const std::string& text, const testing::Matcher<std::string>& message) const {
    expect_input_error([&] { run(adapter_shader(adapter(text)), half_plane({0}, true)); }, message);
  }

 private:
  reference::ScratchFolder folder_;
};

TEST_F(AdapterTest, APipelinesOwnMacrosAreCountedAndItsAnswerIsRight) {
  for (const bool reversed_z : {true, false}) {
    const scene::Frame frame = half_plane({30, 31, 32, 33}, reversed_z);
    const ResolveResult result = run(adapter_shader(adapter_of_nine(), reversed_z), frame);
    const float expected[] = {0.0f, 1.0f / 3.0f, 2.0f / 3.0f, 1.0f};
    for (std::size_t i = 0; i < 4; ++i) {
      // The way through world space moves the samples off their texels' centres by 1e-4 texels.
      EXPECT_NEAR(result.visibility.at(0).at(i), expected[i], 1e-3) << i;
    }
    EXPECT_THAT(result.fetches, testing::AllOf(testing::SizeIs(4), Each(9u)));
  }
}

TEST_F(AdapterTest, TwinsAreNotedWithTheBodyThatIsKept) {
  const CompiledShadowShader compiled = compile(adapter_shader(adapter_of_nine()));
  EXPECT_THAT(compiled.notes, ElementsAre(AllOf(HasSubstr("Common.hlsl:7: note: 'Mean3(half, half, half)'"),
                                                HasSubstr("Common.hlsl:8 is used for both"))));
}

TEST_F(AdapterTest, OnlyUniformsThatAreReadAndNotProvidedAreNamed) {
  const ResolveResult result = run(adapter_shader(adapter_of_nine()), half_plane({0}, true));
  EXPECT_THAT(result.unset_uniforms, ElementsAre("_NobodyProvidesThis"));
}

TEST_F(AdapterTest, AUniformOfTheAdapterIsRead) {
  Adapter nine = adapter_of_nine();
  nine.uniforms.set("_NobodyProvidesThis", glm::vec4(0.25f));
  const ResolveResult result = run(adapter_shader(nine), half_plane({30}, true));
  EXPECT_NEAR(result.visibility.at(0).at(0), 0.25f, 1e-3);
  EXPECT_THAT(result.unset_uniforms, testing::IsEmpty());
}

TEST_F(AdapterTest, ThePlatformMacrosOfTheLibraryServeToo) {
  const ResolveResult result = run(adapter_shader(adapter(R"(
#include "Platform/Platform.hlsl"
TEXTURE2D_SHADOW(_ShadowMap);
SAMPLER_CMP(sampler_ShadowMap);
float4x4 _PenumbraWorldToShadow[5];
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    const float3 at = mul(_PenumbraWorldToShadow[0], float4(positionWS, 1.0)).xyz;
    return SAMPLE_TEXTURE2D_SHADOW(_ShadowMap, sampler_ShadowMap, at);
}
)")),
                                   half_plane({10, 50}, true));
  EXPECT_THAT(result.visibility.at(0), ElementsAre(0.0f, 1.0f));
  EXPECT_THAT(result.fetches, ElementsAre(1u, 1u));
}

TEST_F(AdapterTest, AFetchPastTheMacrosIsRefusedByTheNameOfItsFunction) {
  expect_refused(
      R"(
Texture2D _ShadowMap;
SamplerComparisonState sampler_ShadowMap;
float PeekAtMap(float2 uv) { return _ShadowMap.SampleCmpLevelZero(sampler_ShadowMap, uv, 0.5); }
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel) { return PeekAtMap(pixel); }
)",
      AllOf(HasSubstr("'PeekAtMap'"), HasSubstr("cannot be counted"), HasSubstr("SAMPLE_TEXTURE2D_SHADOW")));
}

TEST_F(AdapterTest, AFileWithoutTheFunctionIsToldItsSignature) {
  expect_refused("float Visibility(float3 positionWS) { return 1.0; }\n",
                 HasSubstr("an adapter defines: float ShadowVisibility(float3 positionWS, float3 normalWS, "
                           "float2 pixel)"));
}

TEST_F(AdapterTest, AMistakeIsShownAtItsPlace) {
  expect_refused(
      "float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)\n{\n    return lit;\n}\n",
      AllOf(HasSubstr("Mine.hlsl:3:12: error:"), HasSubstr("lit")));
}

TEST_F(AdapterTest, ATextureNobodyProvidesIsNamedBesideThoseProvided) {
  expect_refused(
      R"(
#include "Platform/Platform.hlsl"
TEXTURE2D(_Clouds);
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel) { return LOAD_TEXTURE2D(_Clouds, int2(0, 0)).x; }
)",
      AllOf(HasSubstr("texture '_Clouds'"), HasSubstr("does not provide"), HasSubstr("_ShadowMap")));
}

TEST_F(AdapterTest, AFileThatIsNotThereIsNoAdapter) {
  Adapter absent;
  absent.name = "absent";
  absent.file = "absent.hlsl";
  expect_input_error([&] { adapter_shader(absent); },
                     AllOf(HasSubstr("absent.hlsl"), HasSubstr("no such file")));
}

TEST_F(AdapterTest, AMissingPackageRootIsNamed) {
  Adapter nine = adapter_of_nine();
  nine.package_roots.pop_back();
  expect_input_error(
      [&] { compile(adapter_shader(nine)); },
      AllOf(HasSubstr("Mine.hlsl:2"), HasSubstr("no package root is given for 'test.pipeline'")));
}

}  // namespace
}  // namespace penumbra::resolve
