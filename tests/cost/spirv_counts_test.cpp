#include "cost/spirv_counts.h"

#include <gtest/gtest.h>

#include "shaders/compile.h"

namespace penumbra::cost {
namespace {

SpirvCounts counts_of(const std::string& body) {
  shaders::CompileRequest request;
  request.file = "counted.hlsl";
  request.text =
      "Texture2D<float4> map; SamplerState s; float4 a;\n"
      "float4 Main(float2 uv : TEXCOORD0) : SV_Target { " +
      body + " }\n";
  request.stage = hlsl::Stage::fragment;
  const shaders::CompileResult compiled = shaders::compile(request);
  EXPECT_FALSE(compiled.spirv.empty()) << hlsl::format(compiled.diagnostics.at(0));
  return count_spirv(compiled.spirv);
}

TEST(SpirvCounts, EverySampleIsOneTextureInstruction) {
  EXPECT_EQ(counts_of("return a;").texture, 0U);
  EXPECT_EQ(counts_of("return map.Sample(s, uv) + map.Sample(s, uv.yx) * map.Load(int3(1, 2, 0));").texture,
            3U);
}

TEST(SpirvCounts, ArithmeticIsAlu) {
  const SpirvCounts none = counts_of("return a;");
  const SpirvCounts two = counts_of("return sin(a) * a;");
  EXPECT_EQ(none.alu, 0U);
  EXPECT_EQ(two.alu, 2U);
  EXPECT_EQ(two.instructions, none.instructions + 2);
}

TEST(SpirvCounts, BranchesAreControlAndTheirLabelsNothing) {
  const SpirvCounts straight = counts_of("return a;");
  EXPECT_EQ(straight.control, 1U) << "the return";
  const SpirvCounts looping = counts_of(
      "float4 sum = 0; [loop] for (int i = 0; i < int(a.x); ++i) sum += map.Load(int3(i, i, 0)); return "
      "sum;");
  EXPECT_GT(looping.control, straight.control + 3) << "phis, branches and the condition's";
  EXPECT_EQ(looping.texture, 1U);
  EXPECT_LE(looping.alu + looping.texture + looping.memory + looping.control, looping.instructions);
}

TEST(SpirvCounts, WordsThatAreNoModuleAreRefused) {
  EXPECT_THROW(count_spirv({}), std::invalid_argument);
  EXPECT_THROW(count_spirv({1, 2, 3, 4, 5, 6}), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::cost
