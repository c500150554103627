// A finding in a function that was added to the source stands where the source calls it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lint/linted_shader.h"

namespace penumbra::lint {
namespace {

std::vector<std::string> found(const std::string& statements) {
  shaders::CompileRequest request =
      request_of("sampler2D _Map;\nfloat4 Main(float2 uv : TEXCOORD0) : SV_Target\n{\n" + statements + "}\n",
                 hlsl::Stage::fragment);
  request.prepare = true;
  std::vector<std::string> findings;
  for (const std::string& finding : told(lint(request)))
    findings.push_back(finding.substr(0, finding.find(": ")));
  return findings;
}

TEST(CallPlaces, ATextureFunctionOfDirect3D9StandsAtItsCall) {
  EXPECT_THAT(found("  float2 twice = uv * 2;\n  float4 c = twice.xyxy;\n  if (uv.x > 0.5)\n"
                    "    c +=\n      tex2D(_Map, twice);\n  return c;\n"),
              testing::ElementsAre("8:7 warning divergent-derivative"));
}

}  // namespace
}  // namespace penumbra::lint
