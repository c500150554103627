// Tests a user's own shadow function: a small pipeline in URP's manner, and every way an adapter is refused.
#include <gmock/gmock.h>

#include <fstream>

#include "input/input_error_matcher.h"
#include "platform/data_directory.h"
#include "reference/scratch_folder.h"
#include "resolve/graph_runner.h"
#include "resolve/run_once.h"
#include "resolve/synthetic_frame.h"
#include "resolve/test_device.h"

namespace penumbra::resolve {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing_frames::FrameSetup;
using testing_frames::TilePoint;

constexpr int kTexels = 64;

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

  // A file of the folder adapters, which holds a small pipeline in URP's manner as well.
  static Adapter from_folder(const std::string& file) {
    const std::filesystem::path folder =
        std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests/resolve/adapters";
    Adapter adapter;
    adapter.name = "mine";
    adapter.file = folder / file;
    adapter.package_roots = {{"test.core", folder / "core"}, {"test.pipeline", folder / "pipeline"}};
    return adapter;
  }

  // A half-plane over the columns left of the middle, and one receiver in the centre of each of the given
  // texels of a row.
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

  static GraphResult run(const ShadowShader& shader, const scene::Frame& frame) {
    const FrameOnDevice on_device(test_device(), frame);
    return GraphRunner(test_device(), compile(shader)).run(on_device, kCountedOnce);
  }

  static GraphResult run(const Adapter& adapter, const std::vector<int>& texels) {
    return run(adapter_shader(adapter), half_plane(texels, true));
  }

  static void expect_refused(const Adapter& adapter, const testing::Matcher<std::string>& message) {
    expect_input_error([&] { run(adapter, {0}); }, message);
  }
  void expect_refused(const std::string& text, const testing::Matcher<std::string>& message) const {
    expect_refused(adapter(text), message);
  }

 private:
  reference::ScratchFolder folder_;
};

TEST_F(AdapterTest, APipelinesOwnMacrosAreCountedAndItsAnswerIsRight) {
  for (const bool reversed_z : {true, false}) {
    const scene::Frame frame = half_plane({30, 31, 32, 33}, reversed_z);
    const GraphResult result = run(adapter_shader(from_folder("MeanOfNine.hlsl"), reversed_z), frame);
    const float expected[] = {0.0f, 1.0f / 3.0f, 2.0f / 3.0f, 1.0f};
    for (std::size_t i = 0; i < 4; ++i) {
      // The way through world space moves the samples off their texels' centres by 1e-4 texels.
      EXPECT_NEAR(result.visibility.at(0).at(i), expected[i], 1e-3) << i;
    }
    EXPECT_THAT(result.fetches, testing::AllOf(testing::SizeIs(4), Each(9u)));
  }
}

TEST_F(AdapterTest, TwinsAreNotedWithTheBodyThatIsKept) {
  const CompiledGraph compiled = compile(adapter_shader(from_folder("MeanOfNine.hlsl")));
  EXPECT_THAT(compiled.notes, ElementsAre(HasSubstrs("Common.hlsl:7: note: 'Mean3(half, half, half)'",
                                                     "Common.hlsl:8 is used for both")));
}

TEST_F(AdapterTest, OnlyUniformsThatAreReadAndNotProvidedAreNamed) {
  const GraphResult result = run(from_folder("MeanOfNine.hlsl"), {0});
  EXPECT_THAT(result.unset_uniforms, ElementsAre("_NobodyProvidesThis"));
}

TEST_F(AdapterTest, AUniformOfTheAdapterIsRead) {
  Adapter nine = from_folder("MeanOfNine.hlsl");
  nine.uniforms["_NobodyProvidesThis"] = {0.25, 0.0, 0.0, 0.0};
  const GraphResult result = run(nine, {30});
  EXPECT_NEAR(result.visibility.at(0).at(0), 0.25f, 1e-3);
  EXPECT_THAT(result.unset_uniforms, testing::IsEmpty());
}

TEST_F(AdapterTest, ThePlatformMacrosOfTheLibraryServeToo) {
  const GraphResult result = run(from_folder("PlatformMacros.hlsl"), {10, 50});
  EXPECT_THAT(result.visibility.at(0), ElementsAre(0.0f, 1.0f));
  EXPECT_THAT(result.fetches, ElementsAre(1u, 1u));
}

TEST_F(AdapterTest, ReadsWithoutTheMacrosAreCountedToo) {
  const GraphResult result = run(from_folder("PlainReads.hlsl"), {10, 50});
  EXPECT_THAT(result.visibility.at(0), ElementsAre(0.0f, 1.0f));
  EXPECT_THAT(result.fetches, ElementsAre(1u, 2u));
}

// glslang takes the reads of a comparison sampler that do not compare, or crashes on them.
TEST_F(AdapterTest, ASamplerOfTheWrongKindIsRefusedAtItsLine) {
  const auto expect = [this](const std::string& read, const testing::Matcher<std::string>& message) {
    expect_refused(R"(
#include "Platform/Platform.hlsl"
TEXTURE2D(_ShadowMap);
SAMPLER_CMP(sampler_LinearClampCompare);
SAMPLER_CMP(sampler_LinearClamp);
SAMPLER(sampler_ShadowMap);
float Read(float2 uv)
{
    return )" + read + R"(;
}
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel) { return Read(pixel * 0.001); }
)",
                   message);
  };
  const auto comparison = HasSubstrs("Mine.hlsl:9:", "'sampler_LinearClampCompare'",
                                     "is a comparison sampler", "SAMPLE_TEXTURE2D_SHADOW");
  expect("GATHER_RED_TEXTURE2D(_ShadowMap, sampler_LinearClampCompare, uv).x", comparison);
  expect("SAMPLE_TEXTURE2D_LOD(_ShadowMap, sampler_LinearClampCompare, uv, 0.0).x", comparison);
  expect("SAMPLE_TEXTURE2D_LOD(_ShadowMap, sampler_ShadowMap, uv, 0.0).x",
         HasSubstrs("Mine.hlsl:9: ", "'sampler_ShadowMap', which is a comparison sampler",
                    "use sampler_LinearClamp or SAMPLE_TEXTURE2D_SHADOW"));
  expect("SAMPLE_TEXTURE2D_SHADOW(_ShadowMap, sampler_LinearClamp, float3(uv, 0.5))",
         HasSubstrs("Mine.hlsl:9: ", "'sampler_LinearClamp', which is not a comparison",
                    "use sampler_LinearClampCompare"));
}

TEST_F(AdapterTest, APixelThatIsDiscardedIsRefusedAtItsLine) {
  for (const char* statement : {"if (pixel.x < 2.0) discard;", "clip(pixel.x - 2.0);"}) {
    expect_refused(
        std::string("void Unused(float x) { clip(x); }\nvoid GiveUp(float2 pixel)\n{\n    ") + statement + R"(
}
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    GiveUp(pixel);
    return 1.0;
}
)",
        HasSubstrs("Mine.hlsl:4: ", "discards the pixel", "return 1.0"));
  }
}

TEST_F(AdapterTest, ADiscardThatIsNotReachedIsAllowed) {
  const GraphResult result = run(adapter(R"(
void Unused(float x) { clip(x); }
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel) { return 0.5; }
)"),
                                 {0});
  EXPECT_THAT(result.visibility.at(0), ElementsAre(0.5F));
}

TEST_F(AdapterTest, AFileWithoutTheFunctionIsToldItsSignature) {
  expect_refused("float Visibility(float3 positionWS) { return 1.0; }\n",
                 HasSubstr("an adapter defines: float ShadowVisibility(float3 positionWS, float3 normalWS, "
                           "float2 pixel)"));
}

TEST_F(AdapterTest, AMistakeIsShownAtItsPlace) {
  expect_refused(
      "float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)\n{\n    return lit;\n}\n",
      HasSubstrs(": does not compile:\n  ", "Mine.hlsl:3:12: error:", "lit"));
}

TEST_F(AdapterTest, ATextureNobodyProvidesIsNamedBesideThoseProvided) {
  expect_refused(
      R"(
#include "Platform/Platform.hlsl"
TEXTURE2D(_Clouds);
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel) { return LOAD_TEXTURE2D(_Clouds, int2(0, 0)).x; }
)",
      HasSubstrs("Mine.hlsl:3: ", "texture '_Clouds'", "does not provide",
                 "';_Clouds=picture.png' or ';_Clouds=white'", "_ShadowMap"));
}

TEST_F(AdapterTest, ASamplersMessageSaysWhichNamesAreSamplers) {
  Adapter mine = adapter(R"(
#include "Platform/Platform.hlsl"
TEXTURE2D(_Clouds);
SAMPLER(sampler_of_clouds);
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    return SAMPLE_TEXTURE2D_LOD(_Clouds, sampler_of_clouds, pixel, 0.0).x;
}
)");
  mine.textures = {adapter_texture("_Clouds", "white")};
  expect_refused(
      mine, HasSubstrs("Mine.hlsl:4: ", "'sampler_of_clouds'", "'point' or 'linear'", "'clamp' or 'repeat'"));
}

TEST_F(AdapterTest, OnlyTexturesOfTwoDimensionsAreProvided) {
  expect_refused(R"(
#include "Platform/Platform.hlsl"
TEXTURECUBE(_Sky);
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel) { return 1.0; }
)",
                 HasSubstrs("Mine.hlsl:3:", "only 2D textures are provided"));
  // The adapter declares and reads the sky as a pipeline's macros do; the picture would be bound in the
  // cube's place.
  Adapter sky = adapter(R"(
#define SAMPLE_TEXTURECUBE_LOD(map, sampler_map, coord, lod) map.SampleLevel(sampler_map, coord, lod)
#include "Platform/Platform.hlsl"
TextureCube _Sky;
SAMPLER(sampler_Sky);
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    return SAMPLE_TEXTURECUBE_LOD(_Sky, sampler_Sky, normalWS, 0.0).x;
}
)");
  sky.textures = {adapter_texture("_Sky", "white")};
  expect_refused(sky, HasSubstrs("Mine.hlsl:4: ", "'_Sky' is not a plain 2D texture"));
}

TEST_F(AdapterTest, AFunctionThatReturnsAVectorIsRefused) {
  expect_refused(
      "float4 ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel) { return 1.0; }\n",
      HasSubstrs("Mine.hlsl:1: ", "returns more than one number", "returns a float"));
}

// Receivers stand at x of the row's texels: from pixel to pixel the map's u rises by a texel.
TEST_F(AdapterTest, DerivativesAreThoseBetweenPixels) {
  const GraphResult result = run(adapter(R"(
float4x4 _PenumbraWorldToShadow[5];
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    return ddx(mul(_PenumbraWorldToShadow[0], float4(positionWS, 1.0)).x) * 64.0;
}
)"),
                                 {10, 11, 12, 13});
  for (const float steps : result.visibility.at(0)) EXPECT_NEAR(steps, 1.0F, 1e-3F);
  EXPECT_THAT(result.fetches, Each(0U));
}

// The texels of the row hold 0 and 1 in red.
TEST_F(AdapterTest, ATextureOfTheUsersIsReadByTheSamplerThatItsNameSays) {
  const scene::Texture picture{2, 1, {0, 0, 0, 255, 255, 0, 0, 255}};
  const std::map<std::string, float> samples{{"my_point_clamp_sampler", 1.0F},
                                             {"sampler_LinearClamp", 1.0F},
                                             {"sampler_TrilinearRepeat", 0.0F},
                                             {"Point_Repeat", 0.0F},
                                             {"sampler_Picture", 0.0F}};
  for (const auto& [sampler, red] : samples) {
    Adapter reads = from_folder("Picture.hlsl");
    reads.keywords.clear();
    reads.textures = {{"_Picture", picture}};
    ShadowShader shader = adapter_shader(reads);
    shader.defines.emplace_back("SAMPLER_NAME", sampler);
    const GraphResult result = run(shader, half_plane({0}, true));
    EXPECT_EQ(result.visibility.at(0).at(0), red + 2.0F) << sampler;
    EXPECT_THAT(result.fetches, ElementsAre(1U)) << sampler;
  }
}

TEST_F(AdapterTest, UnitysDefaultTexturesAreKnownByName) {
  EXPECT_THAT(adapter_texture("_Mask", "white").picture.rgba, ElementsAre(255, 255, 255, 255));
  EXPECT_THAT(adapter_texture("_Mask", "bump").picture.rgba, ElementsAre(128, 128, 255, 128));
  expect_input_error([] { adapter_texture("_Mask", "whyte"); },
                     HasSubstrs("_Mask=whyte", "neither a number nor a picture's file", "black, bump"));
}

TEST_F(AdapterTest, ASamplersNameMustSayFilterAndAddressing) {
  EXPECT_EQ(inline_sampler("sampler_linear_repeat"), gpu::SamplerKind::linear_repeat);
  EXPECT_EQ(inline_sampler("MyPointClampSampler"), gpu::SamplerKind::point_clamp);
  for (const char* name : {"sampler_Main", "sampler_Linear", "sampler_Clamp", "sampler_LinearMirror",
                           "sampler_LinearClampCompare", "sampler_PointLinearClamp"}) {
    EXPECT_EQ(inline_sampler(name), std::nullopt) << name;
  }
}

TEST_F(AdapterTest, NumbersFillStructsArraysAndMatricesInTheOrderOfTheirDeclaration) {
  Adapter reads = from_folder("Numbers.hlsl");
  reads.uniforms["_Lights[0]"] = {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  reads.uniforms["_Lights[1].shift"] = {0, 0, 0, 2};
  reads.uniforms["_Lights[1].mode"] = {3};
  reads.uniforms["_Lights[1].turn"] = {0, 0, 0, 5, 0, 4};  // the words of the matrix, row by row
  reads.uniforms["_Taps"] = {0, 0, 6};
  reads.uniforms["_Count"] = {7};
  const GraphResult result = run(reads, {0});
  EXPECT_EQ(result.visibility.at(0).at(0), 7654321.0F);
  EXPECT_THAT(result.unset_uniforms, testing::IsEmpty());
}

TEST_F(AdapterTest, NumbersThatDoNotFitTheirUniformAreRefused) {
  const auto expect = [](const std::string& name, const std::vector<double>& numbers,
                         const testing::Matcher<std::string>& message) {
    Adapter reads = from_folder("Numbers.hlsl");
    reads.uniforms[name] = numbers;
    expect_refused(reads, message);
  };
  expect("_Taps", {1, 2}, HasSubstrs("'_Taps'", "3 numbers", "given 2"));
  expect("_Count", {1.5}, HasSubstrs("'_Count'", "integer"));
  expect("_Count", {-1}, HasSubstr("integer"));
  expect("_Count", {1, 2}, HasSubstr("Numbers.hlsl:5: "));
  expect("_Tops", {1, 2, 3},
         HasSubstrs("Numbers.hlsl:6: ", "no uniform '_Tops'", "did you mean '_Taps'?",
                    "it reads _Lights, _Taps, _Count"));
  expect("_Taps[3]", {1}, HasSubstrs("Numbers.hlsl:4: ", "'_Taps' has _Taps[0], _Taps[1], _Taps[2]"));
  expect(
      "_Lights[1].rnge", {1},
      HasSubstrs("Numbers.hlsl:3: ", "did you mean '_Lights[1].range'?", "'_Lights' has _Lights[0].range, "));
}

TEST_F(AdapterTest, AssetsOfAProjectAreIncluded) {
  write("game/Assets/Shaders/Lit.hlsl", "float Lit() { return 0.75; }\n");
  Adapter mine = adapter(R"(
#include "Assets/Shaders/Lit.hlsl"
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel) { return Lit(); }
)");
  mine.project = write("game/Assets/Shaders/Other.hlsl", "").parent_path().parent_path().parent_path();
  EXPECT_THAT(run(mine, {0}).visibility.at(0), ElementsAre(0.75F));
}

TEST_F(AdapterTest, TheLibraryIsIncludedByTheNameOfItsPackageUnlessOneIsGiven) {
  const char* includes = R"(
#include "Packages/com.penumbra.shadows/ShaderLibrary/Platform/Platform.hlsl"
TEXTURE2D(_ShadowMap);
#ifndef MINE
#define MINE 0.5
#endif
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel) { return MINE; }
)";
  EXPECT_THAT(run(adapter(includes), {0}).visibility.at(0), ElementsAre(0.5F));
  write("own/ShaderLibrary/Platform/Platform.hlsl",
        "#define TEXTURE2D(name) Texture2D name\n#define MINE 0.25\n");
  Adapter brings = adapter(includes);
  brings.package_roots = {{"com.penumbra.shadows", brings.file.parent_path() / "own"}};
  EXPECT_THAT(run(brings, {0}).visibility.at(0), ElementsAre(0.25F));
}

TEST_F(AdapterTest, AFileThatIncludesItselfIsNamedAtThatLine) {
  expect_refused(
      "#include \"Platform/Platform.hlsl\"\n\n#include \"Mine.hlsl\"\n",
      AllOf(testing::ContainsRegex(
                "Mine.hlsl:3:[0-9]+: error: includes nest too deeply: .*Mine.hlsl -> .*Mine.hlsl\n"),
            Not(HasSubstr("-> " + (platform::data_directory() / "ShaderLibrary").string()))));
}

TEST_F(AdapterTest, AFileThatIsNotThereIsNoAdapter) {
  Adapter absent;
  absent.name = "absent";
  absent.file = "absent.hlsl";
  expect_input_error([&] { adapter_shader(absent); }, HasSubstrs("absent.hlsl", "no such file"));
}

TEST_F(AdapterTest, AMissingPackageRootIsNamed) {
  Adapter nine = from_folder("MeanOfNine.hlsl");
  nine.package_roots.pop_back();
  expect_input_error([&] { compile(adapter_shader(nine)); },
                     HasSubstrs("MeanOfNine.hlsl:2", "no package root is given for 'test.pipeline'"));
}

}  // namespace
}  // namespace penumbra::resolve
