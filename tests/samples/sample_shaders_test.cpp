// The samples' shaders, and the pages' examples, compile for every target and keyword, without a finding
// of the lint rules: the custom pipeline's as it is, which needs nothing of Unity's, those of URP with
// stand-ins for the URP files that they include. FXC, where it is at hand, warns of nothing in the pages'
// examples; the samples' shaders have package_programs_test.py.
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "cli/program.h"
#include "fxc/at_hand.h"
#include "validate_report.h"

namespace penumbra {
namespace {

using testing::IsEmpty;

const std::string kSource = PENUMBRA_SOURCE_DIR;
const std::string kSunLit = kSource + "/Samples~/CustomPipeline/Shaders/SunLit.shader";
const std::string kForwardLit = kSource + "/Samples~/ForwardShader/Shaders/ForwardLit.shader";

class SampleShaders : public ProgramTest {
 protected:
  nlohmann::json validate(const std::string& shader, const std::vector<std::string>& more = {}) const {
    const std::string unity = kSource + "/tests/samples/unity/com.unity.render-pipelines.";
    std::vector<std::string> command{"validate", shader, "--no-cache", "--format", "json"};
    command.insert(command.end(), {"-o", path("report.json").string()});
    command.insert(command.end(), {"--package-root", "com.penumbra.shadows=" + kSource});
    for (const char* part : {"core", "universal"}) {
      command.insert(command.end(), {"--package-root",
                                     std::string("com.unity.render-pipelines.") + part + "=" + unity + part});
    }
    command.insert(command.end(), more.begin(), more.end());
    const platform::ChildResult result = fxc_ ? run_with_fxc(command) : run(command);
    EXPECT_EQ(result.exit_code, 0) << result.output << result.errors;
    return nlohmann::json::parse(read("report.json"));
  }

  bool fxc_ = false;
};

// The errors, and the warnings of the lint rules, each once. A driver warns of emitted GLSL's own
// temporaries, and only where it has not compiled the same text before.
std::set<std::string> findings(const nlohmann::json& report) {
  std::set<std::string> messages;
  for (const nlohmann::json& variant : results_of(report)) {
    for (const nlohmann::json& message : variant.value("messages", nlohmann::json::array())) {
      if (message.at("severity") == "error" || message.contains("rule")) messages.insert(message.dump());
    }
  }
  return messages;
}

std::set<std::string> passes(const nlohmann::json& report) {
  std::set<std::string> names;
  for (const nlohmann::json& variant : results_of(report)) {
    if (variant.contains("pass")) names.insert(variant["pass"]);
  }
  return names;
}

TEST_F(SampleShaders, TheCustomPipelinesCompileForEveryTarget) {
  const nlohmann::json report = validate(kSunLit);
  EXPECT_EQ(passes(report), (std::set<std::string>{"SunLit", "ShadowCaster"}));
  EXPECT_EQ(report["summary"]["results"], 2 * 2 * 5);
  EXPECT_EQ(report["summary"]["failed"], 0);
  EXPECT_THAT(findings(report), IsEmpty());
}

TEST_F(SampleShaders, TheForwardShaderCompilesForEveryTechniqueShadowAndLight) {
  // Keywords that the stand-ins do not tell apart are left out.
  const nlohmann::json report = validate(
      kForwardLit,
      {"--keywords=-FOG_EXP", "--keywords=-FOG_EXP2", "--keywords=-FOG_LINEAR", "--keywords=-INSTANCING_ON"});
  EXPECT_EQ(passes(report),
            (std::set<std::string>{"ForwardLit", "ShadowCaster", "DepthOnly", "DepthNormals"}));
  const int forward = 1 + 6 * 4 * 2 * 2 * 2, caster = 2 + 1, depth = 1 + 1, normals = 1 + 2;
  EXPECT_EQ(report["summary"]["results"], (forward + caster + depth + normals) * 5);
  EXPECT_EQ(report["summary"]["failed"], 0);
  EXPECT_THAT(findings(report), IsEmpty());
}

TEST_F(SampleShaders, PlanarAndBlobShadowsCompileForEveryTarget) {
  for (const char* name : {"PlanarShadow", "BlobShadow"}) {
    const nlohmann::json report =
        validate(kSource + "/Samples~/PlanarAndBlobShadows/Shaders/" + name + ".shader",
                 {"--keywords=-INSTANCING_ON"});
    EXPECT_EQ(passes(report), std::set<std::string>{name});
    EXPECT_EQ(report["summary"]["results"], 2 * 5);
    EXPECT_EQ(report["summary"]["failed"], 0);
    EXPECT_THAT(findings(report), IsEmpty());
  }
}

TEST_F(SampleShaders, TheShadowVolumesCompileForEveryTarget) {
  for (const std::string name : {"Count", "Darken"}) {
    const nlohmann::json report =
        validate(kSource + "/Samples~/ShadowVolumes/Shaders/ShadowVolume" + name + ".shader",
                 {"--keywords=-INSTANCING_ON"});  // the stand-ins do not tell it apart
    EXPECT_EQ(passes(report), (std::set<std::string>{"ShadowVolume" + name}));
    EXPECT_EQ(report["summary"]["results"], 2 * 5);
    EXPECT_EQ(report["summary"]["failed"], 0);
    EXPECT_THAT(findings(report), IsEmpty());
  }
}

// A page's first block of HLSL, or the one after `skipped` others.
std::string first_block(const std::string& page_file, int skipped = 0) {
  std::ifstream file(kSource + "/" + page_file, std::ios::binary);
  const std::string page((std::istreambuf_iterator<char>(file)), {});
  const std::string start = "```hlsl\n";
  std::size_t begin = page.find(start) + start.size();
  for (int block = 0; block < skipped; ++block) begin = page.find(start, begin) + start.size();
  return page.substr(begin, page.find("```", begin) - begin);
}

// The page's shader for URP inside the text that its reader pastes it into.
std::string urp_shader() {
  return "Shader \"Page\" { SubShader { Pass {\nHLSLPROGRAM\n" + first_block("Documentation~/pipelines.md") +
         "ENDHLSL\n} } }\n";
}

// The shader has the functions of the page on bakes, beside calls of the other functions that read them.
std::string bakes_shader() {
  return R"(Shader "Bakes" { SubShader { Tags { "RenderPipeline" = "UniversalPipeline" } Pass {
HLSLPROGRAM
#pragma vertex Vertex
#pragma fragment Fragment
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
)" + first_block("Documentation~/far-shadows.md") +
         first_block("Documentation~/far-shadows.md", 1) +
         R"(
#include "Packages/com.penumbra.shadows/ShaderLibrary/Far/CloudShadow.hlsl"
#include "Packages/com.penumbra.shadows/ShaderLibrary/Far/HeightFieldTrace.hlsl"
TEXTURE2D(_Heights);
TEXTURE2D(_Clouds);
struct Varyings { float4 position : SV_POSITION; float3 world : TEXCOORD0; };
Varyings Vertex(float4 p : POSITION)
{
    Varyings v;
    v.position = TransformObjectToHClip(p.xyz);
    v.world = TransformObjectToWorld(p.xyz);
    return v;
}
half4 Fragment(Varyings v) : SV_Target
{
    const float3 up = float3(0.0, 1.0, 0.0);
    const float3 towardSun = normalize(float3(0.3, 0.4, 0.5));
    HeightFieldRay ray;
    ray.nearestMetres = 5.0;
    ray.steps = 16;
    ray.jitter = 0.5;
    ray.channels = float2(1.0, 0.0);
    const GroundMap ground = BoundedGroundMap(float4(0.0, 0.0, 1000.0, 1000.0), float2(0.0, 600.0));
    float visibility = FarVisibility(v.world, towardSun);
    visibility *= HeightFieldVisibility(TEXTURE2D_ARGS(_Heights, sampler_HorizonLinearClamp), float2(513.0, 513.0), v.world,
                                        towardSun, 0.0046, ray, ground);
    visibility *= MeshVisibility(v.world, up, towardSun) * ObjectsVisibility(v.world, up, towardSun);
    const DistanceFieldBox box = BoundedFieldBox(_FieldCorner, _FieldSize);
    visibility *= FieldHardVisibility(TEXTURE3D_ARGS(_Field, sampler_FieldLinearClamp), v.world, towardSun, 10.0, 32, box);
    const CloudLayer layer = BoundedCloudLayer(float4(-4000.0, -4000.0, 8000.0, 8000.0), 1500.0, 0.1);
    visibility *= CloudVisibility(TEXTURE2D_ARGS(_Clouds, sampler_HorizonLinearClamp), v.world, towardSun, layer);
    return visibility;
}
ENDHLSL
} } }
)";
}

// The page's fog, with a shadow map and without, is that of a surface that the pass knows of.
std::string volumetric_shader() {
  return R"(Shader "Volumetric" { SubShader { Tags { "RenderPipeline" = "UniversalPipeline" } Pass {
HLSLPROGRAM
#pragma vertex Vertex
#pragma fragment Fragment
)" + first_block("Documentation~/other-shadows.md", 1) +
         R"(
struct Varyings { float4 position : SV_POSITION; float3 world : TEXCOORD0; };
Varyings Vertex(float4 p : POSITION)
{
    Varyings v;
    v.position = TransformObjectToHClip(p.xyz);
    v.world = TransformObjectToWorld(p.xyz);
    return v;
}
half4 Fragment(Varyings v) : SV_Target
{
    return FogBefore(v.world, v.position.xy);
}
ENDHLSL
} } }
)";
}

// The page's vertex program leaves out what has no shadow by a clip.
std::string planar_shader() {
  return R"(Shader "Planar" { SubShader { Tags { "RenderPipeline" = "UniversalPipeline" } Pass {
HLSLPROGRAM
#pragma vertex Vertex
#pragma fragment Fragment
)" + first_block("Documentation~/other-shadows.md") +
         R"(
struct Varyings { float4 position : SV_POSITION; float valid : TEXCOORD0; };
Varyings Vertex(float4 p : POSITION)
{
    const float4 shadow = InShadow(p.xyz, 0.5);
    Varyings v;
    v.position = TransformWorldToHClip(shadow.xyz);
    v.valid = shadow.w;
    return v;
}
half4 Fragment(Varyings v) : SV_Target
{
    clip(v.valid - 0.9999);
    return half4(0.4, 0.4, 0.4, 1.0);
}
ENDHLSL
} } }
)";
}

// Each keyword that it lists changes the shader: one that does not is a finding.
TEST_F(SampleShaders, ThePagesCompilesWithAndWithoutAShadowMap) {
  write("Page.shader", urp_shader());
  const nlohmann::json report = validate(path("Page.shader").string());
  EXPECT_EQ(report["summary"]["results"], (1 + 4) * 5);
  EXPECT_EQ(report["summary"]["failed"], 0);
  EXPECT_THAT(findings(report), IsEmpty());
}

TEST_F(SampleShaders, FunctionsThatReadBakesCompileForEveryTarget) {
  write("Bakes.shader", bakes_shader());
  const nlohmann::json report = validate(path("Bakes.shader").string());
  EXPECT_EQ(report["summary"]["results"], 2 * 5);
  EXPECT_EQ(report["summary"]["failed"], 0);
  EXPECT_THAT(findings(report), IsEmpty());
}

TEST_F(SampleShaders, PlanarShadowOfThePageCompilesForEveryTarget) {
  write("Planar.shader", planar_shader());
  const nlohmann::json report = validate(path("Planar.shader").string());
  EXPECT_EQ(report["summary"]["results"], 2 * 5);
  EXPECT_EQ(report["summary"]["failed"], 0);
  EXPECT_THAT(findings(report), IsEmpty());
}

TEST_F(SampleShaders, FogOfThePageCompilesForEveryTarget) {
  write("Volumetric.shader", volumetric_shader());
  const nlohmann::json report = validate(path("Volumetric.shader").string());
  EXPECT_EQ(report["summary"]["results"], (1 + 4) * 5);
  EXPECT_EQ(report["summary"]["failed"], 0);
  EXPECT_THAT(findings(report), IsEmpty());
}

TEST_F(SampleShaders, UnitysCompilerWarnsOfNothingInThePagesExamples) {
  PENUMBRA_NEEDS_FXC();
  fxc_ = true;
  write("Page.shader", urp_shader());
  write("Bakes.shader", bakes_shader());
  write("Planar.shader", planar_shader());
  write("Volumetric.shader", volumetric_shader());
  const nlohmann::json report = validate(path("").string(), {"--target", "d3d11"});
  EXPECT_EQ(report["summary"]["results"], 5 + 2 + 2 + 5);
  EXPECT_EQ(report["summary"]["failed"], 0);
  for (const nlohmann::json& variant : results_of(report))
    EXPECT_THAT(variant.value("messages", nlohmann::json::array()), IsEmpty());
}

}  // namespace
}  // namespace penumbra
