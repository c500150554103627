#include "shaders/reflect.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "shader_files.h"
#include "shaders/compile.h"

namespace penumbra::shaders {
namespace {

Reflection reflect_text(const std::string& text, bool optimise = true) {
  CompileRequest request;
  request.file = "shader.hlsl";
  request.text = text;
  request.optimise = optimise;
  return reflect(compile(request).spirv);
}

const Resource* find(const Reflection& reflection, const std::string& name) {
  for (const Resource& resource : reflection.resources)
    if (resource.name == name) return &resource;
  return nullptr;
}

const std::string everything = R"(
Texture2D<float> _Map;
SamplerState sampler_Map;
SamplerComparisonState sampler_Compare;
Texture2D<float4> _Unused;
StructuredBuffer<float4> _First;
StructuredBuffer<float4> _Second;
RWTexture2D<float> _Image;
RWStructuredBuffer<float> _Out;
float3 _Direction;
float4x4 _Matrices[2];
float2 _Pairs[3];
int _Count;
[numthreads(8, 4, 2)]
void Main(uint3 id : SV_DispatchThreadID)
{
    float v = _Map.SampleLevel(sampler_Map, _Direction.xy, 0) +
              _Map.SampleCmpLevelZero(sampler_Compare, _Pairs[id.x], 0.5) + _First[id.x].x + _Second[id.y].y;
    _Image[id.xy] = mul(_Matrices[id.z], _First[id.x]).x;
    _Out[id.x] = v + _Count;
}
)";

TEST(Reflect, FindsEveryReachableResourceByItsName) {
  const Reflection reflection = reflect_text(everything);
  const std::pair<const char*, ResourceKind> expected[] = {
      {"$Global", ResourceKind::uniform_block}, {"_Map", ResourceKind::sampled_image},
      {"sampler_Map", ResourceKind::sampler},   {"sampler_Compare", ResourceKind::sampler},
      {"_First", ResourceKind::storage_buffer}, {"_Second", ResourceKind::storage_buffer},
      {"_Image", ResourceKind::storage_image},  {"_Out", ResourceKind::storage_buffer}};
  for (const auto& [name, kind] : expected) {
    const Resource* resource = find(reflection, name);
    ASSERT_NE(resource, nullptr) << name;
    EXPECT_EQ(resource->kind, kind) << name;
  }
  EXPECT_EQ(find(reflection, "_Unused"), nullptr);
  EXPECT_EQ(find(reflect_text(everything, false), "_Unused"), nullptr);
  EXPECT_EQ(reflection.workgroup_size, (std::array<std::uint32_t, 3>{8, 4, 2}));
}

TEST(Reflect, NoTwoResourcesShareABinding) {
  for (const bool optimise : {true, false}) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> places;
    for (const Resource& resource : reflect_text(everything, optimise).resources)
      EXPECT_TRUE(places.emplace(resource.set, resource.binding).second) << resource.name;
  }
}

TEST(Reflect, RegistersOfTwoKindsDoNotMeet) {
  const Reflection reflection = reflect_text(
      compute_shader("_A.SampleLevel(sampler_A, float2(0, 0), 0)",
                     "Texture2D<float> _A : register(t0);\nSamplerState sampler_A : register(s0);\n"));
  ASSERT_NE(find(reflection, "_A"), nullptr);
  EXPECT_NE(find(reflection, "_A")->binding, find(reflection, "sampler_A")->binding);
}

// In std140 a vec3 ends at 12, an array's stride is 16, and a column of a matrix takes 16.
TEST(Reflect, MembersHaveTheirStd140Places) {
  const Reflection reflection = reflect_text(everything);
  const Resource* block = find(reflection, "$Global");
  ASSERT_NE(block, nullptr);
  ASSERT_EQ(block->members.size(), 4U);
  const UniformMember& direction = block->members[0];
  EXPECT_EQ(direction.name, "_Direction");
  EXPECT_EQ(direction.offset, 0U);
  EXPECT_EQ(direction.size, 12U);
  EXPECT_EQ(direction.array_length, 0U);
  const UniformMember& matrices = block->members[1];
  EXPECT_EQ(matrices.offset, 16U);
  EXPECT_EQ(matrices.array_length, 2U);
  EXPECT_EQ(matrices.array_stride, 64U);
  EXPECT_EQ(matrices.matrix_stride, 16U);
  EXPECT_TRUE(
      matrices
          .row_major);  // HLSL's default is column-major; SPIR-V, naming rows for columns, calls it row-major
  const UniformMember& pairs = block->members[2];
  EXPECT_EQ(pairs.offset, 144U);
  EXPECT_EQ(pairs.array_length, 3U);
  EXPECT_EQ(pairs.array_stride, 16U);
  EXPECT_EQ(pairs.size, 2 * 16U + 8U);
  EXPECT_EQ(block->members[3].offset, 192U);
  EXPECT_EQ(block->members[3].size, 4U);
}

TEST(Reflect, ConstantBuffersAreKnownByTheirOwnName) {
  const Reflection reflection =
      reflect_text(compute_shader("_Scale", "cbuffer PerFrame { float4 _Tint; float _Scale; };\n"));
  const Resource* block = find(reflection, "PerFrame");
  ASSERT_NE(block, nullptr);
  ASSERT_EQ(block->members.size(), 2U);
  EXPECT_EQ(block->members[1].offset, 16U);
}

TEST(Reflect, WordsThatAreNoModuleAreRefused) {
  EXPECT_THROW(reflect({}), std::invalid_argument);
  EXPECT_THROW(reflect({1, 2, 3, 4, 5, 6}), std::invalid_argument);
  EXPECT_THROW(reflect({0x07230203, 0x10300, 0, 10, 0, 0xFFFF0001}), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::shaders
