// Tests the rule divergent-barrier.
#include "lint/stage_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lint/linted_shader.h"

namespace penumbra::lint {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> with(const std::string& body) {
  return findings_of(
      "divergent-barrier",
      "groupshared float S[8]; groupshared uint N; StructuredBuffer<uint> B; float _Count;\n"
      "RWStructuredBuffer<float> W; RWTexture2D<float> T;\n"
      "[numthreads(8, 1, 1)] void Main(uint3 id : SV_DispatchThreadID, uint3 group : SV_GroupID,\n"
      "    uint at : SV_GroupIndex)\n{\n    S[at] = 1;\n" +
          body + "\n    W[id.x] = S[7 - at];\n}\n",
      hlsl::Stage::compute);
}

constexpr const char* barrier = "    GroupMemoryBarrierWithGroupSync();";

TEST(DivergentBarrier, UnderAConditionOnThreads) {
  EXPECT_THAT(
      with("    if (at > 3)\n    " + std::string(barrier)),
      ElementsAre(
          "8:9 error divergent-barrier: a barrier with group sync is in divergent control flow: not all "
          "threads of a group may reach it, by the condition at line 7: move it out of the condition, or "
          "make the condition one of constants and SV_GroupID"));
}

TEST(DivergentBarrier, AfterAnEarlyReturn) {
  EXPECT_THAT(
      with("    if (id.x > 3) return;\n" + std::string(barrier)),
      ElementsAre("8:5 error divergent-barrier: a barrier with group sync is in divergent control flow: some "
                  "threads of a group may have returned before it, by the condition at line 7: let them go "
                  "on to it, and put the work of the others into a condition"));
}

TEST(DivergentBarrier, InALoopOfThreads) {
  EXPECT_THAT(with("    for (uint i = 0; i < id.x; ++i)\n    " + std::string(barrier)),
              ElementsAre(HasSubstr("may leave its loop at different times")));
}

TEST(DivergentBarrier, ByWhatEachThreadReadsForItself) {
  for (const char* condition : {"S[at] > 3", "W[id.x] > 3", "T[id.xy] > 3", "B[group.x + at] > 3"})
    EXPECT_THAT(with("    if (" + std::string(condition) + ")\n    " + barrier),
                ElementsAre(HasSubstr("8:9 error")))
        << condition;
  EXPECT_THAT(with("    uint was; InterlockedAdd(N, 1, was); if (was > 3)\n    " + std::string(barrier)),
              ElementsAre(HasSubstr("8:9 error")));
}

TEST(DivergentBarrier, NotWhereTheWholeGroupDecidesAlike) {
  for (const char* condition : {"_Count > 3", "WaveGetLaneCount() > 16", "group.x > 3", "B[group.x] > 3",
                                "N > 3", "W[group.x] > 3", "T[group.xy] > 3"})
    EXPECT_THAT(with("    if (" + std::string(condition) + ")\n    " + barrier), IsEmpty()) << condition;
  EXPECT_THAT(
      with(std::string("    for (uint i = 0; i < 3; ++i) {\n    if (at > i) S[at] += 1;\n") + barrier + " }"),
      IsEmpty());
  EXPECT_THAT(with(std::string("    if (at > 3) S[at] = 2;\n") + barrier + "\n    if (at > 5) return;"),
              IsEmpty());
}

}  // namespace
}  // namespace penumbra::lint
