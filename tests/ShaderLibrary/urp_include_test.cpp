// Shadows.hlsl, SpotShadows.hlsl and VolumetricShadows.hlsl compile by their one include, for every keyword,
// in both depth conventions and without gather.
#include <gtest/gtest.h>

#include <set>

#include "shaders/compile.h"
#include "shaders/reflect.h"

namespace penumbra::shader_library_tests {
namespace {

using Defines = std::vector<std::pair<std::string, std::string>>;

shaders::CompileResult compile_with(const std::string& umbrellas, const std::string& expression,
                                    const Defines& defines) {
  shaders::CompileRequest request;
  request.file = "lit.hlsl";
  request.text = "#include \"Platform/Platform.hlsl\"\n#include \"UrpGlobals.hlsl\"\n" + umbrellas +
                 "float4 Main(float4 pixel : SV_Position, float3 positionWS : TEXCOORD0, float3 normalWS : "
                 "TEXCOORD1) : SV_Target\n{ return " +
                 expression + "; }\n";
  request.stage = hlsl::Stage::fragment;
  request.defines = defines;
  request.prepare = true;  // glslang would warn of [fastopt], an attribute of FXC's
  request.package_roots = {{"com.penumbra.shadows", PENUMBRA_SOURCE_DIR}};
  request.include_directories = {
      std::string(PENUMBRA_SOURCE_DIR) + "/ShaderLibrary",
      std::string(PENUMBRA_SOURCE_DIR) +
          "/tools/programs/shaders/unity/com.unity.render-pipelines.universal/ShaderLibrary"};
  return shaders::compile(request);
}

const std::string kShadows = "#include \"Packages/com.penumbra.shadows/ShaderLibrary/Shadows.hlsl\"\n";
const std::string kSpotShadows =
    "#include \"Packages/com.penumbra.shadows/ShaderLibrary/SpotShadows.hlsl\"\n";
const std::string kVolumetricShadows =
    "#include \"Packages/com.penumbra.shadows/ShaderLibrary/VolumetricShadows.hlsl\"\n";
const std::string kRay = "PenumbraMainLightRayVisibility(positionWS, normalWS, pixel.x, int(pixel.y), 0.5)";
const std::string kMainLight = "PenumbraMainLightVisibility(positionWS, normalWS, pixel.xy)";
const std::string kSpotLight =
    "PenumbraAdditionalLightVisibility(int(pixel.x), positionWS, normalWS, pixel.xy, 0.05)";

shaders::CompileResult compile_umbrella(const Defines& defines) {
  return compile_with(kShadows, kMainLight, defines);
}

bool binds(const shaders::CompileResult& result, const std::string& name) {
  for (const shaders::Resource& resource : shaders::reflect(result.spirv).resources) {
    if (resource.name == name) return true;
  }
  return false;
}

class UrpInclude : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(EveryKeyword, UrpInclude,
                         ::testing::Values("_", "_PENUMBRA_HARD", "_PENUMBRA_BILINEAR", "_PENUMBRA_FOUR_TAP",
                                           "_PENUMBRA_TENT_3X3", "_PENUMBRA_TENT_7X7", "_PENUMBRA_PCSS",
                                           "_PENUMBRA_PCSS_POISSON", "_PENUMBRA_PCSS_HDRP", "_PENUMBRA_SMRT",
                                           "_PENUMBRA_PCSS_GODOT", "_PENUMBRA_DPCF_FILAMENT",
                                           "_PENUMBRA_PCSS_FILAMENT", "_PENUMBRA_SINGLE_LOOP"),
                         [](const auto& test) { return "Keyword" + test.param; });

TEST_P(UrpInclude, CompilesAndBindsTheMap) {
  for (const Defines& more : {Defines{}, Defines{{"UNITY_REVERSED_Z", "1"}},
                              Defines{{"SHADER_API_GLES3", "1"}}, Defines{{"SHADER_API_GLCORE", "1"}}}) {
    Defines defines = more;
    defines.emplace_back(GetParam(), "1");
    const shaders::CompileResult result = compile_umbrella(defines);
    for (const hlsl::Diagnostic& diagnostic : result.diagnostics) ADD_FAILURE() << hlsl::format(diagnostic);
    ASSERT_FALSE(result.spirv.empty());
    EXPECT_TRUE(binds(result, "_MainLightShadowmapTexture"));
  }
}

TEST_P(UrpInclude, FallsBackToComparisonsWhereThereIsNoGather) {
  const std::set<std::string> comparing{"_",
                                        "_PENUMBRA_HARD",
                                        "_PENUMBRA_BILINEAR",
                                        "_PENUMBRA_FOUR_TAP",
                                        "_PENUMBRA_TENT_3X3",
                                        "_PENUMBRA_TENT_7X7"};
  const bool compares = comparing.contains(GetParam());
  // The single loop loads depths without any sampler.
  const bool gathers = !compares && GetParam() != "_PENUMBRA_SINGLE_LOOP";
  EXPECT_EQ(binds(compile_umbrella({{GetParam(), "1"}}), "sampler_PenumbraPointClamp"), gathers);
  // There is also no gather where the API has one, but not of a texture that compares: OpenGL ES 3.1 and
  // later, and OpenGL. WebGPU is treated as OpenGL.
  for (const char* api : {"SHADER_API_GLES3", "SHADER_API_GLCORE", "SHADER_API_WEBGPU"}) {
    for (const char* target : {"35", "45"}) {
      EXPECT_FALSE(binds(compile_umbrella({{GetParam(), "1"}, {api, "1"}, {"SHADER_TARGET", target}}),
                         "sampler_PenumbraPointClamp"))
          << api << " " << target;
      if (compares) continue;
      const auto compiled = [&](const std::string& keyword) {
        return compile_umbrella({{keyword, "1"}, {api, "1"}, {"SHADER_TARGET", target}}).spirv;
      };
      EXPECT_EQ(compiled(GetParam()), compiled("_PENUMBRA_TENT_7X7")) << api << " " << target;
    }
  }
}

// The file compiles alone and beside the other, which reads raw depths or compares; also where raw reads are
// undefined.
TEST_P(UrpInclude, OfRaysComparesAloneAndBesideIt) {
  for (const std::string& umbrellas :
       {kVolumetricShadows, kVolumetricShadows + kShadows, kShadows + kVolumetricShadows}) {
    const bool both = umbrellas != kVolumetricShadows;
    for (const Defines& more :
         {Defines{}, Defines{{"UNITY_REVERSED_Z", "1"}}, Defines{{"SHADER_API_GLES3", "1"}}}) {
      Defines defines = more;
      defines.emplace_back(GetParam(), "1");
      const shaders::CompileResult result =
          compile_with(umbrellas, both ? kRay + " * " + kMainLight : kRay, defines);
      for (const hlsl::Diagnostic& diagnostic : result.diagnostics) ADD_FAILURE() << hlsl::format(diagnostic);
      ASSERT_FALSE(result.spirv.empty());
      EXPECT_TRUE(binds(result, "sampler_PenumbraLinearClampCompare"));
      EXPECT_FALSE(!both && binds(result, "sampler_PenumbraPointClamp"));
    }
  }
}

TEST(UrpIncludeOfMaps, IsAnErrorWhereNobodyBindsThem) {
  const shaders::CompileResult alone = compile_umbrella({{"_PENUMBRA_VSM", "1"}});
  EXPECT_TRUE(alone.spirv.empty());
  ASSERT_FALSE(alone.diagnostics.empty());
  EXPECT_NE(alone.diagnostics.front().message.find("reads maps that only the renderer feature's passes make"),
            std::string::npos)
      << alone.diagnostics.front().message;
  const shaders::CompileResult bound =
      compile_umbrella({{"_PENUMBRA_VSM", "1"}, {"PENUMBRA_MAPS_BOUND", "1"}});
  ASSERT_FALSE(bound.spirv.empty());
  EXPECT_TRUE(binds(bound, "_PenumbraMomentsTexture"));
  // The filter that stands in for it there reads no map.
  EXPECT_FALSE(compile_umbrella({{"_PENUMBRA_VSM", "1"}, {"SHADER_API_GLES3", "1"}}).spirv.empty());
}

TEST(UrpIncludeOfMaps, BindsThemAndTheShadowMap) {
  const Defines keyword{{"_PENUMBRA_SINGLE_LOOP_PLANES", "1"}, {"PENUMBRA_MAPS_BOUND", "1"}};
  for (const char* direction : {"UNITY_REVERSED_Z", "_"}) {
    Defines defines = keyword;
    defines.emplace_back(direction, "1");
    const shaders::CompileResult result = compile_umbrella(defines);
    for (const hlsl::Diagnostic& diagnostic : result.diagnostics) ADD_FAILURE() << hlsl::format(diagnostic);
    ASSERT_FALSE(result.spirv.empty());
    for (const char* name : {"_MainLightShadowmapTexture", "_PenumbraDepthPlanesTexture"})
      EXPECT_TRUE(binds(result, name)) << name;
  }
  for (const char* api : {"SHADER_API_GLES3", "SHADER_API_GLCORE"}) {
    Defines defines = keyword;
    defines.emplace_back(api, "1");
    EXPECT_EQ(compile_umbrella(defines).spirv,
              compile_umbrella({{"_PENUMBRA_TENT_7X7", "1"}, {api, "1"}}).spirv)
        << api;
  }
}

// The file compiles alone, and beside the other in either order; with URP's arrays and with its structured
// buffers.
TEST(UrpSpotInclude, CompilesAndBindsTheAtlas) {
  for (const std::string& umbrellas : {kSpotShadows, kSpotShadows + kShadows, kShadows + kSpotShadows}) {
    const bool both = umbrellas != kSpotShadows;
    for (const char* buffers : {"0", "1"}) {
      for (const Defines& more :
           {Defines{}, Defines{{"UNITY_REVERSED_Z", "1"}}, Defines{{"_PENUMBRA_PCSS", "1"}},
            Defines{{"SHADER_API_GLES3", "1"}}, Defines{{"SHADER_API_GLCORE", "1"}}}) {
        Defines defines = more;
        defines.emplace_back("_ADDITIONAL_LIGHT_SHADOWS", "1");
        defines.emplace_back("USE_STRUCTURED_BUFFER_FOR_LIGHT_DATA", buffers);
        const shaders::CompileResult result =
            compile_with(umbrellas, both ? kSpotLight + " * " + kMainLight : kSpotLight, defines);
        for (const hlsl::Diagnostic& diagnostic : result.diagnostics)
          ADD_FAILURE() << hlsl::format(diagnostic);
        ASSERT_FALSE(result.spirv.empty());
        EXPECT_TRUE(binds(result, "_AdditionalLightsShadowmapTexture"));
        const bool compares = !more.empty() && more.front().first.starts_with("SHADER_API");
        EXPECT_EQ(binds(result, "sampler_PenumbraPointClamp"), !compares);
      }
    }
  }
}

TEST(UrpSpotInclude, ReadsNothingWithoutUrpsKeyword) {
  const shaders::CompileResult result = compile_with(kSpotShadows, kSpotLight, {});
  ASSERT_FALSE(result.spirv.empty());
  EXPECT_TRUE(shaders::reflect(result.spirv).resources.empty());
}

}  // namespace
}  // namespace penumbra::shader_library_tests
