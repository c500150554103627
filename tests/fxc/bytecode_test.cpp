// Counts bytecode for a program's cost: programs whose cost is known, and damaged bytes.
#include "fxc/bytecode.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "fxc/at_hand.h"
#include "fxc/judge.h"

namespace penumbra::fxc {
namespace {

const char* const kKernel =
    "groupshared float shared1[100];\n"
    "groupshared float4 shared2[3];\n"
    "Texture2D<float4> map; SamplerState smp; RWStructuredBuffer<float4> o;\n"
    "[numthreads(10, 5, 2)] void Main(uint3 id : SV_DispatchThreadID, uint at : SV_GroupIndex)\n"
    "{ shared1[at] = id.x; shared2[id.y % 3u] = map.Load(int3(id.xy, 0)); "
    "GroupMemoryBarrierWithGroupSync();\n"
    "  o[id.x] = shared1[99u - at] + shared2[at % 3u] + map.SampleLevel(smp, id.xy, 0) + map.GatherRed(smp, "
    "id.xy); }\n";

std::string bytecode_of(const char* text) {
  Judge judge(require_fxc());
  return judge.compile({text, "Main", "cs_5_0"}).bytecode;
}

TEST(FxcBytecode, TellsTheCostOfAKernel) {
  PENUMBRA_NEEDS_FXC();
  const std::optional<BytecodeCost> cost = bytecode_cost(bytecode_of(kKernel));
  ASSERT_TRUE(cost);
  EXPECT_EQ(cost->group_shared, 100 * 4U + 3 * 16U);
  EXPECT_EQ(cost->group_size, (std::array<std::uint32_t, 3>{10, 5, 2}));
  EXPECT_EQ(cost->textures, 3U);
  EXPECT_EQ(cost->branches, 0U);
  EXPECT_GT(cost->instructions, 10U);
  EXPECT_GT(cost->temporaries, 0U);
}

TEST(FxcBytecode, CountsALoop) {
  PENUMBRA_NEEDS_FXC();
  const std::optional<BytecodeCost> cost = bytecode_cost(bytecode_of(
      "RWStructuredBuffer<float> o; uint n; [numthreads(1, 1, 1)] void Main(uint3 id : SV_DispatchThreadID)\n"
      "{ float s = 0; [loop] for (uint i = 0; i < n; ++i) s = s * 0.5 + o[i]; o[id.x] = s; }"));
  ASSERT_TRUE(cost);
  EXPECT_GE(cost->branches, 1U);
  EXPECT_EQ(cost->group_shared, 0U);
}

TEST(FxcBytecode, DamagedBytesHaveNoCostAndDoNoHarm) {
  PENUMBRA_NEEDS_FXC();
  const std::string whole = bytecode_of(kKernel);
  for (std::size_t size = 0; size < whole.size(); size += 7) bytecode_cost(whole.substr(0, size));
  EXPECT_FALSE(bytecode_cost(whole.substr(0, 100)));
  EXPECT_FALSE(bytecode_cost("DXBC"));
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    std::string damaged = whole;
    for (int j = 0; j < 4; ++j) damaged[random() % damaged.size()] = static_cast<char>(random());
    bytecode_cost(damaged);
  }
}

}  // namespace
}  // namespace penumbra::fxc
