// Tables become initialisers only where the variable never holds anything else; all other code stays word for
// word.
#include "shaders/spirv_module.h"

#include <gtest/gtest.h>

#include "shaders/assembled_module.h"

namespace penumbra::shaders {
namespace {

// %20 is a table of two floats, %21 another; %30 is the local variable, %31 one more of its type.
std::string shader(const std::string& variables, const std::string& code) {
  return "OpCapability Shader\nOpMemoryModel Logical GLSL450\nOpEntryPoint GLCompute %1 \"main\"\n"
         "OpExecutionMode %1 LocalSize 1 1 1\nOpName %30 \"table\"\nOpDecorate %30 RelaxedPrecision\n"
         "%2 = OpTypeVoid\n%3 = OpTypeFunction %2\n%4 = OpTypeFloat 32\n%5 = OpTypeInt 32 0\n"
         "%6 = OpConstant %5 2\n%7 = OpTypeArray %4 %6\n%8 = OpTypePointer Function %7\n"
         "%9 = OpTypePointer Function %4\n%10 = OpConstant %4 0.25\n%11 = OpConstant %4 0.75\n"
         "%12 = OpConstant %5 1\n%14 = OpTypeFunction %2 %8\n"
         "%20 = OpConstantComposite %7 %10 %11\n%21 = OpConstantComposite %7 %11 %10\n"
         "%1 = OpFunction %2 None %3\n%50 = OpLabel\n" +
         variables + code + "OpReturn\nOpFunctionEnd\n" +
         "%60 = OpFunction %2 None %14\n%61 = OpFunctionParameter %8\n%62 = "
         "OpLabel\nOpReturn\nOpFunctionEnd\n";
}

const std::string kPlain = "%30 = OpVariable %8 Function\n";
const std::string kRead = "%40 = OpAccessChain %9 %30 %12\n%41 = OpLoad %4 %40\n";

TEST(ConstantTables, BecomeInitialisers) {
  SpirvModule module = assembled(shader(kPlain, "OpStore %30 %20\n" + kRead));
  initialise_tables(module);
  EXPECT_EQ(module, assembled(shader("%30 = OpVariable %8 Function %20\n", kRead)));
  EXPECT_TRUE(spvtools::SpirvTools(SPV_ENV_VULKAN_1_1).Validate(module));
}

TEST(ConstantTables, BecomeInitialisersWhereTheSameOneIsStoredTwiceAndReadWholeAndInPartsOfParts) {
  const std::string whole = "%42 = OpLoad %7 %30\n%43 = OpAccessChain %9 %40\n%44 = OpLoad %4 %43\n";
  SpirvModule module = assembled(shader(kPlain, "OpStore %30 %20\n" + kRead + "OpStore %30 %20\n" + whole));
  initialise_tables(module);
  EXPECT_EQ(module, assembled(shader("%30 = OpVariable %8 Function %20\n", kRead + whole)));
}

TEST(ConstantTables, VariablesThatHoldAnythingElseStayAsTheyAre) {
  const std::string second = kPlain + "%31 = OpVariable %8 Function\n";
  for (const std::string& text : {
           shader(kPlain, "OpStore %30 %20\n" + kRead + "OpStore %30 %21\n"),  // another table is stored
           shader(kPlain, "OpStore %30 %20\n" + kRead + "OpStore %40 %10\n"),  // one element is stored
           shader(kPlain, "OpStore %30 %20\n" + kRead + "%42 = OpAccessChain %9 %40\nOpStore %42 %10\n"),
           shader(kPlain,
                  "OpStore %30 %20\n%42 = OpFunctionCall %2 %60 %30\n" + kRead),  // any callee may write
           shader(second, "OpStore %30 %20\nOpCopyMemory %30 %31\n" + kRead),
           shader(kPlain, kRead),  // nothing at all is stored
           shader("%30 = OpVariable %8 Function %21\n",
                  "OpStore %30 %20\n" + kRead),  // it has an initialiser
           shader(kPlain, "%42 = OpUndef %7\nOpStore %30 %42\n" + kRead),
       }) {
    SpirvModule module = assembled(text);
    const SpirvModule before = module;
    initialise_tables(module);
    EXPECT_EQ(module, before) << text;
  }
}

TEST(ConstantTables, WhatIsNoModuleIsLeftAlone) {
  for (SpirvModule words : malformed_modules()) {
    const SpirvModule before = words;
    initialise_tables(words);
    EXPECT_EQ(words, before);
  }
}

}  // namespace
}  // namespace penumbra::shaders
