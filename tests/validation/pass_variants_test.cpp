#include "validation/source_variants.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "shaders/shader_files.h"
#include "validation/validate_techniques.h"

namespace penumbra::validation {
namespace {

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

}  // namespace
}  // namespace penumbra::validation
