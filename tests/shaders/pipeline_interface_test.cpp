#include "shaders/pipeline_interface.h"

#include <gmock/gmock.h>

#include <map>

#include "shaders/shader_files.h"

namespace penumbra::shaders {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<std::uint32_t> compiled(const std::string& text, hlsl::Stage stage) {
  CompileRequest request;
  request.file = "interface.hlsl";
  request.text = text;
  request.stage = stage;
  const CompileResult result = compile(request);
  EXPECT_FALSE(result.spirv.empty()) << hlsl::format(result.diagnostics.at(0));
  return result.spirv;
}

TEST(PipelineInterface, EveryKindOfDescriptorWithItsCount) {
  const PipelineInterface interface = pipeline_interface(
      compiled("cbuffer Block { float4 a; }; Texture2D<float4> plain; SamplerState samplers[2];\n"
               "RWTexture2D<float4> image; Buffer<float4> texels; RWBuffer<float4> writable;\n"
               "StructuredBuffer<float4> list; Texture2D<float4> many[3];\n"
               "[numthreads(1, 1, 1)] void Main(uint3 id : SV_DispatchThreadID) {\n"
               "writable[id.x] = texels[id.x] + list[id.x] + plain.SampleLevel(samplers[1], a.xy, 0);\n"
               "image[id.xy] = many[2].SampleLevel(samplers[0], a.xy, 0); }",
               hlsl::Stage::compute),
      "Main");
  std::map<std::string, std::pair<DescriptorKind, std::uint32_t>> found;
  for (const Descriptor& descriptor : interface.descriptors)
    found[descriptor.name] = {descriptor.kind, descriptor.count};
  const std::map<std::string, std::pair<DescriptorKind, std::uint32_t>> expected{
      {"Block", {DescriptorKind::uniform_buffer, 1}},
      {"plain", {DescriptorKind::sampled_image, 1}},
      {"samplers", {DescriptorKind::sampler, 2}},
      {"image", {DescriptorKind::storage_image, 1}},
      {"texels", {DescriptorKind::uniform_texel_buffer, 1}},
      {"writable", {DescriptorKind::storage_texel_buffer, 1}},
      {"list", {DescriptorKind::storage_buffer, 1}},
      {"many", {DescriptorKind::sampled_image, 3}}};
  EXPECT_EQ(found, expected);
  EXPECT_THAT(interface.inputs, IsEmpty());
}

TEST(PipelineInterface, LocationsHaveTheSemanticsOfTheSource) {
  CompileRequest request;
  request.file = "interface.hlsl";
  request.text =
      "struct Vertex { float3 normal : NORMAL; float4 colour : color; float4 position : POSITION; float2 uv "
      ": TexCoord3;\n"
      "  uint id : SV_VertexID; };\n"
      "float4 Main(Vertex v, float4 tangent : TANGENT) : SV_Position { return v.position + float4(v.uv, "
      "v.id, tangent.w); }";
  request.stage = hlsl::Stage::vertex;
  const CompileResult result = compile(request);
  ASSERT_FALSE(result.spirv.empty());
  std::map<int, std::uint32_t> components;
  for (const StageLocation& input : pipeline_interface(result.spirv, "Main").inputs)
    components[static_cast<int>(input.location)] = input.components;
  std::map<std::string, std::uint32_t> read;
  for (const SignatureElement& element : result.signature)
    if (!element.output && element.read) read[element.semantic] = components.at(element.location);
  const std::map<std::string, std::uint32_t> expected{{"POSITION0", 4}, {"TANGENT0", 4}, {"TEXCOORD3", 2}};
  EXPECT_EQ(read, expected);
  std::vector<std::string> declared;
  for (const SignatureElement& element : result.signature)
    declared.push_back(element.semantic + (element.output ? " out" : ""));
  EXPECT_THAT(declared, testing::UnorderedElementsAre("NORMAL0", "COLOR0", "POSITION0", "TEXCOORD3",
                                                      "SV_VERTEXID", "TANGENT0", "SV_POSITION out"));
}

TEST(PipelineInterface, LocationsOfMatricesArraysAndIntegers) {
  const PipelineInterface interface = pipeline_interface(
      compiled("float4 Main(float4 p : SV_Position, [[vk::location(5)]] nointerpolation uint2 u : A,\n"
               "[[vk::location(1)]] float3 list[2] : B, [[vk::location(0)]] float f : C) : SV_Target\n"
               "{ return p + float4(list[0] + list[1], f) + float4(u, u); }",
               hlsl::Stage::fragment),
      "Main");
  ASSERT_THAT(interface.inputs, SizeIs(4)) << "the position is a built-in";
  EXPECT_EQ(interface.inputs[0].components, 1U);
  EXPECT_EQ(interface.inputs[1].location, 1U);
  EXPECT_EQ(interface.inputs[2].location, 2U);
  EXPECT_EQ(interface.inputs[2].components, 3U);
  EXPECT_EQ(interface.inputs[3].location, 5U);
  EXPECT_EQ(interface.inputs[3].type, ScalarType::uint32);
  ASSERT_THAT(interface.outputs, SizeIs(1));
  EXPECT_EQ(interface.outputs[0].components, 4U);
}

TEST(PipelineInterface, PushConstantsFromTheStart) {
  const PipelineInterface interface =
      pipeline_interface(compiled("[[vk::push_constant]] cbuffer Pushed { float4 a; float2 b; };\n"
                                  "float4 Main() : SV_Target { return a + b.xyxy; }",
                                  hlsl::Stage::fragment),
                         "Main");
  EXPECT_EQ(interface.push_constant_bytes, 24U);
}

TEST(PipelineInterface, AMissingEntryPointIsNamedWithThoseThereAre) {
  const std::vector<std::uint32_t> spirv =
      compiled("float4 Main() : SV_Target { return 1; }", hlsl::Stage::fragment);
  try {
    pipeline_interface(spirv, "Other");
    FAIL() << "an entry point was made up";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("no entry point 'Other'; it has Main"));
  }
  EXPECT_THROW(pipeline_interface({1, 2, 3}, "Main"), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::shaders
