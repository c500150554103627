// Reads the library's shaders and, where PENUMBRA_URP_PACKAGES names a folder with URP's packages, URP's
// lighting: the project's own preprocessor reads every variant, and as glslang's does.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "preprocessing/both_preprocessors.h"
#include "shaders/package_shader.h"
#include "shaders/source_memory.h"
#include "techniques/technique_list.h"
#include "variants/platform_defines.h"

namespace penumbra::preprocessing {
namespace {

namespace fs = std::filesystem;
using shaders::CompileRequest;

const fs::path root = PENUMBRA_SOURCE_DIR;

// The comparison cuts files once for all readings, as the program does.
class Comparison {
 public:
  void of(const CompileRequest& request, const std::string& variant) {
    const shaders::PreprocessedSource read = shaders::expand(request, own_);
    const shaders::PreprocessedSource by_glslang = shaders::expand(request, glslang_);
    EXPECT_NE(by_glslang.text, "") << variant;
    EXPECT_TRUE(read.text == by_glslang.text) << variant;
    EXPECT_EQ(read.sources.names(), by_glslang.sources.names()) << variant;
    EXPECT_EQ(read.absent, by_glslang.absent) << variant;
    EXPECT_EQ(read.found_by_case, by_glslang.found_by_case) << variant;
  }

  std::size_t left_to_glslang() const { return own_.left_to_glslang(); }

 private:
  shaders::SourceMemory own_;
  shaders::SourceMemory glslang_{true};
};

std::set<std::vector<std::string>> keyword_sets() {
  std::set<std::vector<std::string>> sets{{}};
  const techniques::TechniqueList list = techniques::read_technique_list(root);
  for (const techniques::Technique& technique : list.techniques)
    sets.insert(technique.keyword_sets.begin(), technique.keyword_sets.end());
  return sets;
}

TEST(LibrarySources, AreReadAsGlslangReadsThem) {
  const std::set<std::vector<std::string>> sets = keyword_sets();
  Comparison comparison;
  for (const fs::path& file : {shaders::package_shader_file(), shaders::debug_shader_file()}) {
    const shaders::PackageShader shader(file);
    for (const std::string& pass : shader.pass_names()) {
      for (const std::vector<std::string>& keywords : sets) {
        CompileRequest request =
            shader.request(pass, hlsl::Stage::fragment, keywords, keywords.size() % 2 == 0);
        request.prepare = true;
        comparison.of(request, pass + (keywords.empty() ? "" : " " + keywords.front()));
      }
    }
  }
  EXPECT_EQ(comparison.left_to_glslang(), 0U);
}

constexpr const char* lit = R"(
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
struct Varyings { float4 clip : SV_POSITION; float3 world : TEXCOORD0; half3 normal : TEXCOORD1; };
half4 Main(Varyings input) : SV_Target {
  Light light = GetMainLight(TransformWorldToShadowCoord(input.world));
  return half4(LightingLambert(light.color * light.shadowAttenuation, light.direction, input.normal), 1);
}
)";

const std::vector<std::vector<std::string>> urp_keywords{
    {},
    {"_MAIN_LIGHT_SHADOWS", "_SHADOWS_SOFT"},
    {"_MAIN_LIGHT_SHADOWS_CASCADE", "_ADDITIONAL_LIGHTS", "_ADDITIONAL_LIGHT_SHADOWS"},
    {"_MAIN_LIGHT_SHADOWS_SCREEN", "_SCREEN_SPACE_OCCLUSION", "LIGHTMAP_ON", "DIRLIGHTMAP_COMBINED"},
    {"_FORWARD_PLUS", "_LIGHT_LAYERS", "_REFLECTION_PROBE_BLENDING", "_LIGHT_COOKIES"},
    {"INSTANCING_ON", "_ADDITIONAL_LIGHTS_VERTEX", "_SHADOWS_SOFT_HIGH", "FOG_LINEAR"}};

TEST(UrpSources, AreReadAsGlslangReadsThem) {
  const char* const folder = std::getenv("PENUMBRA_URP_PACKAGES");  // NOLINT(concurrency-mt-unsafe)
  if (folder == nullptr) GTEST_SKIP() << "PENUMBRA_URP_PACKAGES is not set";
  Comparison comparison;
  for (const variants::GraphicsApi api : variants::all_graphics_apis) {
    for (const std::vector<std::string>& keywords : urp_keywords) {
      CompileRequest request;
      request.file = "Lit.hlsl";
      request.text = lit;
      request.stage = hlsl::Stage::fragment;
      request.prepare = true;
      for (const char* name : {"core", "universal", "universal-config"}) {
        const std::string package = std::string("com.unity.render-pipelines.") + name;
        request.package_roots.push_back({package, fs::path(folder) / package});
      }
      for (const auto& [name, value] : variants::platform_defines({api, false}, request.stage, 45))
        request.defines.emplace_back(name, value);
      for (const std::string& keyword : keywords) request.defines.emplace_back(keyword, "1");
      comparison.of(request, keywords.empty() ? "no keywords" : keywords.front());
    }
  }
  EXPECT_EQ(comparison.left_to_glslang(), 0U);
}

}  // namespace
}  // namespace penumbra::preprocessing
