// Tests what a compiled shader's module says of itself.
#include "spirv/code.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <stdexcept>

#include "shaders/compile.h"

namespace penumbra::spirv {
namespace {

std::vector<std::uint32_t> compiled() {
  shaders::CompileRequest request;
  request.file = "code.hlsl";
  request.text = R"(cbuffer Settings { float4 a; float4 b; };
RWStructuredBuffer<float4> Out;
[numthreads(1, 1, 1)] void Main(uint3 id : SV_DispatchThreadID)
{
    if (id.x > 3)
        Out[id.x] = b;
})";
  request.debug_lines = true;
  return shaders::compile(request).spirv;
}

Id named(const Code& code, const std::string& name) {
  for (Id id = 1; id < code.id_bound(); ++id)
    if (code.name(id) == name) return id;
  return 0;
}

TEST(SpirvCode, FindsNamesMembersAndDecorations) {
  const Code code(compiled());
  const Id settings = named(code, "Settings");
  ASSERT_NE(settings, 0U);
  EXPECT_EQ(code.op(settings), spv::OpTypeStruct);
  EXPECT_EQ(code.member_name(settings, 1), "b");
  EXPECT_EQ(code.member_name(settings, 9), "9") << "without a name";
  EXPECT_EQ(code.member_decoration(settings, 1, spv::DecorationOffset), 16U);
  EXPECT_TRUE(code.decoration(settings, spv::DecorationBlock).has_value());
  EXPECT_FALSE(code.decoration(settings, spv::DecorationFlat).has_value());
  EXPECT_EQ(code.definition(static_cast<Id>(code.id_bound())), nullptr);
  EXPECT_EQ(code.op(0), spv::OpNop);
}

TEST(SpirvCode, HasTheEntryFunctionWithItsBlocks) {
  const Code code(compiled());
  const Function* entry = code.function(named(code, "Main"));
  ASSERT_NE(entry, nullptr);
  EXPECT_EQ(entry->blocks.size(), 3U) << "before, inside and behind the if";
  for (const Block& block : entry->blocks) EXPECT_LT(block.begin, block.end);
  EXPECT_EQ(code.function(0), nullptr);
}

TEST(SpirvCode, KnowsTheLineOfAnInstruction) {
  const Code code(compiled());
  const auto store = std::find_if(code.instructions().begin(), code.instructions().end(),
                                  [](const Instruction& one) { return one.op == spv::OpStore; });
  ASSERT_NE(store, code.instructions().end());
  EXPECT_EQ(store->place.line, 6);
  EXPECT_EQ(code.file_name(store->place.file), "code.hlsl");
  EXPECT_EQ(code.ids(*store).size(), 2U) << "pointer and value";
}

TEST(SpirvCode, RefusesWhatIsNoModule) {
  EXPECT_THROW(Code({}), std::invalid_argument);
  EXPECT_THROW(Code({1, 2, 3, 4, 5, 6}), std::invalid_argument);
  std::vector<std::uint32_t> words = compiled();
  words[3] = 0xFFFFFFFF;
  EXPECT_THROW(Code{words}, std::invalid_argument) << "a bound beyond all ids";
  words = compiled();
  words.pop_back();
  EXPECT_THROW(Code{words}, std::invalid_argument) << "cut off";
}

}  // namespace
}  // namespace penumbra::spirv
