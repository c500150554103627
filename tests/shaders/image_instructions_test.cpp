#include "shaders/image_instructions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "shader_files.h"
#include "shaders/compile.h"

namespace penumbra::shaders {
namespace {

std::vector<std::string> uncounted(const std::string& expression) {
  CompileRequest request;
  request.file = "shader.hlsl";
  request.text = compute_shader(expression, R"(
Texture2D<float> _A;
SamplerState sampler_A;
SamplerComparisonState sampler_C;
RWTexture2D<float> _Image;
float CountedSample(Texture2D<float> t, SamplerState s) { return t.SampleLevel(s, float2(0, 0), 0); }
float PassOn(Texture2D<float> t, SamplerState s) { return CountedSample(t, s); }
float RawSample(Texture2D<float> t, SamplerState s) { return t.SampleLevel(s, float2(0, 0), 0); }
)");
  request.optimise = false;
  const CompileResult compiled = compile(request);
  EXPECT_FALSE(hlsl::has_errors(compiled.diagnostics));
  std::vector<std::string> opcodes;
  for (const ImageInstruction& found : image_instructions_outside(compiled.spirv, "Counted"))
    if (found.function != "RawSample" ||
        expression.find("RawSample") != std::string::npos)  // it stands unused too
      opcodes.push_back(found.opcode);
  return opcodes;
}

TEST(ImageInstructions, CountedFunctionsAreLetThrough) {
  EXPECT_THAT(uncounted("PassOn(_A, sampler_A)"), testing::IsEmpty());
}

TEST(ImageInstructions, EveryKindOfReadIsFound) {
  EXPECT_THAT(uncounted("RawSample(_A, sampler_A)"), testing::ElementsAre("OpImageSampleExplicitLod"));
  EXPECT_THAT(uncounted("_A.SampleLevel(sampler_A, float2(0, 0), 0)"),
              testing::ElementsAre("OpImageSampleExplicitLod"));
  EXPECT_THAT(uncounted("_A.SampleCmpLevelZero(sampler_C, float2(0, 0), 0)"),
              testing::ElementsAre("OpImageSampleDrefExplicitLod"));
  EXPECT_THAT(uncounted("_A.Load(int3(0, 0, 0))"), testing::ElementsAre("OpImageFetch"));
  EXPECT_THAT(uncounted("_A[id.xy]"), testing::ElementsAre("OpImageFetch"));
  EXPECT_THAT(uncounted("_A.GatherRed(sampler_A, float2(0, 0)).x"), testing::ElementsAre("OpImageGather"));
  EXPECT_THAT(uncounted("_Image[id.xy]"), testing::ElementsAre("OpImageRead"));
}

TEST(ImageInstructions, ArithmeticIsNoRead) {
  EXPECT_THAT(uncounted("sin(1.0)"), testing::IsEmpty());
}

TEST(ImageInstructions, WordsThatAreNoModuleAreRefused) {
  EXPECT_THROW(image_instructions_outside({}, "Counted"), std::invalid_argument);
  EXPECT_THROW(image_instructions_outside({1, 2, 3, 4, 5}, "Counted"), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::shaders
