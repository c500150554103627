// Functions without a caller go with what is said of them; all else stays word for word.
#include "shaders/spirv_module.h"

#include <gtest/gtest.h>

#include "shaders/assembled_module.h"

namespace penumbra::shaders {
namespace {

// %30 is on top so that all modules have one bound.
const std::string kHead =
    "OpCapability Shader\nOpMemoryModel Logical GLSL450\nOpEntryPoint Fragment %1 \"main\"\n"
    "OpExecutionMode %1 OriginUpperLeft\nOpName %1 \"main\"\n";
const std::string kTypes =
    "%30 = OpTypeVoid\n%2 = OpTypeFunction %30\n%3 = OpTypeFloat 32\n%4 = OpTypeFunction %3\n"
    "%5 = OpConstant %3 1\n";
const std::string kMain =
    "%1 = OpFunction %30 None %2\n%6 = OpLabel\n%7 = OpFunctionCall %3 %8\nOpReturn\nOpFunctionEnd\n";
const std::string kCalled =
    "%8 = OpFunction %3 None %4\n%9 = OpLabel\n%10 = OpFAdd %3 %5 %5\nOpReturnValue %10\nOpFunctionEnd\n";

TEST(UncalledFunctions, GoWithTheirNamesAndDecorations) {
  const std::string calls_the_other_and_main_does_not_call_it =
      "%11 = OpFunction %3 None %4\n%12 = OpLabel\n%13 = OpFunctionCall %3 %8\n%14 = OpFAdd %3 %13 %5\n"
      "OpReturnValue %14\nOpFunctionEnd\n";
  const std::string called_by_that_alone =
      "%15 = OpFunction %3 None %4\n%16 = OpLabel\n%17 = OpFunctionCall %3 %11\nOpReturnValue %17\n"
      "OpFunctionEnd\n";
  SpirvModule module =
      assembled(kHead + "OpName %11 \"gone\"\nOpName %8 \"stays\"\nOpName %14 \"gone too\"\n" +
                "OpDecorate %14 RelaxedPrecision\nOpDecorate %10 RelaxedPrecision\n" + kTypes + kMain +
                calls_the_other_and_main_does_not_call_it + kCalled + called_by_that_alone);
  drop_uncalled_functions(module);
  EXPECT_EQ(module, assembled(kHead + "OpName %8 \"stays\"\nOpDecorate %10 RelaxedPrecision\n" + kTypes +
                              kMain + kCalled));
}

TEST(UncalledFunctions, AreNoneWhereAllAreCalled) {
  const SpirvModule module = assembled(kHead + kTypes + kMain + kCalled);
  SpirvModule after = module;
  drop_uncalled_functions(after);
  EXPECT_EQ(after, module);
}

TEST(UncalledFunctions, WhatIsNoModuleIsLeftAlone) {
  for (SpirvModule words : malformed_modules()) {
    const SpirvModule before = words;
    drop_uncalled_functions(words);
    EXPECT_EQ(words, before);
  }
}

}  // namespace
}  // namespace penumbra::shaders
