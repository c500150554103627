// Whole numbers that reach a fragment shader are flat wherever they stand, and nothing else becomes so.
#include "shaders/module_corrections.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shaders/compile.h"

namespace penumbra::shaders {
namespace {

CompileResult compiled(const std::string& text, hlsl::Stage stage) {
  CompileRequest request;
  request.file = "flat.hlsl";
  request.text = text;
  request.stage = stage;
  return compile(request);
}

// The number of OpDecorate ... Flat (SPIR-V specification 3.20: 14).
int flat_decorations(const SpirvModule& module) {
  int count = 0;
  for (std::size_t at = 5; at < module.size(); at += module[at] >> 16U)
    count += (module[at] & 0xFFFFU) == 71U && module[at + 2] == 14U ? 1 : 0;
  return count;
}

const std::string kNested = R"(struct Inner { uint id : ID; int2 pair[2] : PAIR; float3 n : N; };
struct Outer { float4 p : SV_Position; Inner inner; uint other : OTHER; };
)";

TEST(FlatInputs, AreAllWholeNumbersInStructsInStructs) {
  const CompileResult fragment = compiled(kNested +
                                              "float4 Main(Outer o) : SV_Target { return o.inner.id + "
                                              "o.inner.pair[1].x + o.inner.n.x + o.other; }",
                                          hlsl::Stage::fragment);
  ASSERT_FALSE(fragment.spirv.empty()) << format(fragment.diagnostics.at(0));
  EXPECT_EQ(flat_decorations(fragment.spirv), 3);
}

TEST(FlatInputs, LeaveOtherStagesAndFinishedModulesAlone) {
  const CompileResult vertex =
      compiled("float4 Main(uint a : A) : SV_Position { return a; }", hlsl::Stage::vertex);
  ASSERT_FALSE(vertex.spirv.empty()) << format(vertex.diagnostics.at(0));
  SpirvModule again = vertex.spirv;
  flatten_integer_inputs(again);
  EXPECT_EQ(again, vertex.spirv);
  const CompileResult fragment =
      compiled("float4 Main(uint a : A, float b : B) : SV_Target { return a + b; }", hlsl::Stage::fragment);
  again = fragment.spirv;
  flatten_integer_inputs(again);
  EXPECT_EQ(again, fragment.spirv);
  SpirvModule empty;
  flatten_integer_inputs(empty);
  EXPECT_TRUE(empty.empty());
}

}  // namespace
}  // namespace penumbra::shaders
