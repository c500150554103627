// Tests what rule groupshared-initialiser says of FXC, Unity's compiler.
#include <gtest/gtest.h>

#include <string>

#include "fxc/at_hand.h"
#include "fxc/judge.h"

namespace penumbra::lint {
namespace {

TEST(GroupsharedInitialiser, EveryThreadWritesItWithFxc) {
  PENUMBRA_NEEDS_FXC();
  fxc::Judge fxc(fxc::require_fxc());
  const auto bytecode = [&](const std::string& initialiser, const std::string& first) {
    return fxc
        .compile({"groupshared uint n" + initialiser +
                      ";\nRWStructuredBuffer<uint> w;\n[numthreads(8, 1, 1)] void Main(uint t : "
                      "SV_GroupIndex) { " +
                      first + " InterlockedAdd(n, t); GroupMemoryBarrierWithGroupSync(); w[t] = n; }\n",
                  "Main", "cs_5_0"})
        .bytecode;
  };
  EXPECT_FALSE(bytecode(" = 3", "").empty());
  EXPECT_EQ(bytecode(" = 3", ""), bytecode("", "n = 3;"));
}

}  // namespace
}  // namespace penumbra::lint
