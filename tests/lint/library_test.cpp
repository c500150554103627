// The library's own techniques keep the rules, which shows that the rules say nothing about good shaders.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "lint/linted_shader.h"
#include "techniques/technique_call.h"
#include "techniques/technique_list.h"

namespace penumbra::lint {
namespace {

constexpr const char* entry = R"(
ShadowTile _Tile;
float4 Fragment(float4 position : SV_Position, float3 shadowCoord : TEXCOORD0, float2 depthGradient : TEXCOORD1,
                nointerpolation float2 rotation : TEXCOORD2) : SV_Target
{
    ShadowReceiver receiver;
    receiver.shadowCoord = shadowCoord;
    receiver.depthGradient = depthGradient;
    receiver.rotation = rotation;
    return ResolveTechnique(receiver, _Tile, 0);
}
)";

TEST(LintLibrary, EveryTechniqueWithEveryKeywordSet) {
  const techniques::TechniqueList list =
      techniques::read_technique_list(PENUMBRA_SOURCE_DIR "/tests/study/StudyVariants.technique.json");
  std::size_t modules = 0;
  std::set<std::string> found;
  for (const techniques::Technique& technique : list.techniques) {
    if (technique.graph.filter() == nullptr) continue;  // it has passes of a .shader alone
    for (const std::vector<std::string>& keywords : technique.keyword_sets) {
      shaders::CompileRequest request;
      request.file = technique.name;
      request.text = techniques::emit_technique_call(list, technique).source() + entry;
      request.entry = "Fragment";
      request.stage = hlsl::Stage::fragment;
      for (const std::string& keyword : technique.keywords) request.defines.emplace_back(keyword, "1");
      for (const std::string& keyword : keywords) request.defines.emplace_back(keyword, "1");
      request.include_directories = list.include_directories();
      request.optimise = false;
      request.debug_lines = true;
      shaders::CompileResult result = shaders::compile(request);
      ASSERT_FALSE(result.spirv.empty()) << technique.name;
      ++modules;
      for (const hlsl::Diagnostic& finding :
           lint_module({result.spirv, request.stage, technique.name, result.sources, 0}))
        found.insert(std::filesystem::path(finding.file).filename().string() + ": " + finding.rule);
    }
  }
  EXPECT_GE(modules, list.techniques.size());
  EXPECT_THAT(found, testing::IsEmpty());
}

}  // namespace
}  // namespace penumbra::lint
