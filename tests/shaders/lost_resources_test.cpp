// A module that reads a texture without saying which one is refused, though SPIRV-Tools finds it valid.
#include "shaders/module_problems.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "shader_files.h"
#include "shaders/compile.h"
#include "shaders/reflect.h"

namespace penumbra::shaders {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST(LostResources, AnyWordsAreRead) {
  EXPECT_THAT(lost_resources({}), IsEmpty());
  EXPECT_THAT(lost_resources({1, 2, 3, 4, 5, 0}), IsEmpty());
  EXPECT_THAT(lost_resources({1, 2, 3, 4, 5, 0xFFFF0001}), IsEmpty());
  EXPECT_THAT(lost_resources({1, 2, 3, 4, 5, 0x00010001, 0x00010056, 0x00010019, 0x0002005F, 7}), IsEmpty());
}

// The words are OpTypeImage %1, OpUndef %1 %2, OpImageFetch %3 %4 %2 ...
TEST(LostResources, AreFoundByTheirWords) {
  SpirvModule module{0x07230203, 0x00010300, 0, 9, 0};
  module.insert(module.end(), {0x00090019, 1, 8, 1, 0, 0, 0, 1, 0});
  module.insert(module.end(), {0x00030001, 1, 2});
  EXPECT_THAT(lost_resources(module), IsEmpty());  // nobody reads it
  module.insert(module.end(), {0x0005005F, 7, 3, 2, 6});
  ASSERT_THAT(lost_resources(module), SizeIs(1));
  EXPECT_THAT(lost_resources(module)[0].message, HasSubstr("a texture is read uninitialised"));
}

// glslang's back end says what it leaves out, and returns success.
TEST(MissingFunctionality, IsAnError) {
  for (const char* expression : {"Swizzle()", "Array()"}) {
    CompileRequest request;
    request.file = "missing.hlsl";
    request.text = compute_shader(expression, R"(
Texture2D A; Texture2D B;
float Swizzle() { float4x4 m = 1; float3 v = m._14_24_34; return v.x; }
float Array() { Texture2D t[2] = { A, B }; return t[0].Load(0).x; }
)");
    const CompileResult compiled = compile(request);
    EXPECT_THAT(compiled.spirv, IsEmpty()) << expression;
    ASSERT_FALSE(compiled.diagnostics.empty()) << expression;
    EXPECT_EQ(compiled.diagnostics[0].severity, hlsl::Severity::error);
    EXPECT_THAT(compiled.diagnostics[0].message, HasSubstr("Missing functionality"));
  }
}

// Registers of different kinds and spaces share their numbers; bindings are numbered anew.
TEST(Registers, OfEveryKindGetABindingOfTheirOwn) {
  CompileRequest request;
  request.file = "registers.hlsl";
  request.text = R"(
cbuffer B0 : register(b0) { float b; } cbuffer B1 : register(b0, space1) { float c; } cbuffer B2 : register(b1) { float d; }
Texture2D T : register(t0); Buffer<float> U : register(t1); StructuredBuffer<float> V : register(t0, space1);
ByteAddressBuffer W : register(t2); SamplerState S : register(s0); SamplerComparisonState S1 : register(s1);
RWTexture2D<float4> X : register(u0); RWStructuredBuffer<float> Out : register(u1); RWByteAddressBuffer Y : register(u0, space3);
float Loose : register(c0);
[numthreads(1, 1, 1)] void Main() {
  X[uint2(0, 0)] = 1; Y.Store(0, 1);
  Out[0] = b + c + d + T.SampleLevel(S, 0.5, 0).x + U[0] + V[0] + W.Load(0) + T.SampleCmpLevelZero(S1, 0.5, 0) + Loose;
})";
  const CompileResult compiled = compile(request);
  ASSERT_THAT(compiled.diagnostics, IsEmpty()) << format(compiled.diagnostics[0]);
  std::map<std::uint32_t, std::string> names;
  for (const Resource& resource : reflect(compiled.spirv).resources) {
    EXPECT_TRUE(names.emplace(resource.binding, resource.name).second) << resource.name;
    EXPECT_EQ(resource.set, resource.name == "B1" || resource.name == "V" ? 1U
                            : resource.name == "Y"                        ? 3U
                                                                          : 0U);
  }
  EXPECT_EQ(names.size(), 14U);  // T stands for two: one is read by comparison
  EXPECT_EQ(names.rbegin()->first, 13U);
}

}  // namespace
}  // namespace penumbra::shaders
