#include "validation/pass_variants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include "shaders/shader_files.h"
#include "validation/validate_techniques.h"

namespace penumbra::validation {
namespace {

bool defines(const SourceVariant& variant, const std::string& keyword) {
  const auto& all = variant.unit.compile.defines;
  return std::any_of(all.begin(), all.end(), [&](const auto& define) { return define.first == keyword; });
}

bool resolve_has_the_masks_keyword(const std::string& technique) {
  ValidationRequest request;
  request.techniques = techniques::read_technique_list(PENUMBRA_SOURCE_DIR);
  for (const SourceVariant& variant : pass_variants(request, request.techniques->find(technique), {})) {
    if (variant.unit.pass == "Resolve" && variant.unit.compile.stage == hlsl::Stage::fragment)
      return defines(variant, "_PENUMBRA_MASK");
  }
  ADD_FAILURE() << technique << " has no Resolve pass";
  return false;
}

constexpr const char* kManifest = R"({
"graphs": [{"name": "g", "textures": [{"name": "marks", "divisor": 8, "format": "r16f"},
                                      {"name": "visibility", "format": "r8"}],
  "passes": [{"name": "Mark", "kind": "compute", "compute": "T.compute", "writes": {"_Marks": "marks"},
              "groups": {"texels_of": "marks"}},
             {"name": "Draw", "kind": "raster", "shader": "T.shader", "reads": {"_MarksRead": "marks"},
              "writes": ["visibility"]}],
  "visibility": "visibility"}],
"techniques": [{"name": "t", "title": "T", "family": "t", "source": "s", "graph": "g", "keyword_sets": [[]]}]})";

TEST(PassVariants, EveryPassOfAGraphIsCompiledForEveryTarget) {
  const shaders::ShaderFiles files;
  files.write("T.compute",
              "#pragma kernel Mark\nRWTexture2D<float> _Marks;\n[numthreads(8, 8, 1)]\n"
              "void Mark(uint3 id : SV_DispatchThreadID) { _Marks[id.xy] = 1.0; }\n");
  files.write(
      "T.shader",
      "Shader \"T\" { SubShader { Pass { Name \"Draw\"\nHLSLPROGRAM\n#pragma vertex V\n#pragma fragment "
      "F\nTexture2D<float> _MarksRead;\n"
      "float4 V(uint id : SV_VertexID) : SV_Position { return float4(id & 1, id >> 1, 0, 1); }\n"
      "float4 F(float4 at : SV_Position) : SV_Target { return _MarksRead.Load(int3(at.xy, 0)); }\n"
      "ENDHLSL\n} } }\n");
  ValidationRequest request;
  request.techniques = techniques::read_technique_list(files.write("T.technique.json", kManifest));
  const ValidationReport report = validate(request);
  EXPECT_EQ(report.records.size(), 3U * 5U) << "a kernel, a vertex and a fragment stage";
  for (const VariantRecord& record : report.records) {
    const bool lacks = record.target == "essl310" && record.stage == hlsl::Stage::compute;
    EXPECT_EQ(record.status, lacks ? VariantStatus::failed : VariantStatus::passed)
        << record.pass << " " << record.target;
    if (!lacks) continue;
    ASSERT_FALSE(record.diagnostics.empty());
    const hlsl::Diagnostic& said = record.diagnostics.back();
    EXPECT_NE(said.file.find("T.technique.json"), std::string::npos);
    EXPECT_EQ(said.line, 2);
    EXPECT_NE(said.message.find("cannot write 'r16f', the format of 'marks'"), std::string::npos);
  }
}

TEST(PassVariants, ResolveReadsTheMaskOnlyInAChainThatHasOne) {
  EXPECT_TRUE(resolve_has_the_masks_keyword("screen-tent-5-masked"));
  EXPECT_FALSE(resolve_has_the_masks_keyword("screen-tent-5"));
}

// Of every technique that the feature offers exits for, whose keyword may be none, in both depth directions.
TEST(PassVariants, TheScreenPassIsCompiledWithExits) {
  ValidationRequest request;
  request.techniques = techniques::read_technique_list(PENUMBRA_SOURCE_DIR);
  std::size_t offered = 0;
  std::size_t without_keyword = 0;
  for (const techniques::Selection& selection : request.techniques->selections)
    offered += selection.value && selection.has_exits() ? 1 : 0;
  const std::vector<SourceVariant> variants = screen_exits_variants(request);
  EXPECT_EQ(variants.size(), 2 * offered);
  for (const SourceVariant& variant : variants) {
    EXPECT_EQ(variant.unit.pass, "Resolve");
    EXPECT_TRUE(variant.unit.technique.ends_with("-exits")) << variant.unit.technique;
    EXPECT_TRUE(defines(variant, "_PENUMBRA_EXITS")) << variant.unit.technique;
    without_keyword += variant.unit.technique == "tent-5-plane-exits" ? 1 : 0;
  }
  EXPECT_EQ(without_keyword, 2U);
}

TEST(PassVariants, TechniquesAreCompiledWithExitsToo) {
  ValidationRequest request;
  request.techniques = techniques::read_technique_list(PENUMBRA_SOURCE_DIR);
  std::set<std::string> compiled;
  for (const SourceVariant& variant : source_variants(request)) compiled.insert(variant.unit.technique);
  for (const techniques::Technique& technique : request.techniques->with_exits)
    EXPECT_TRUE(compiled.contains(technique.name)) << technique.name;
}

}  // namespace
}  // namespace penumbra::validation
