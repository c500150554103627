// Tests instructions of modules: whole ones, and words that are none.
#include "spirv/words.h"

#include <gmock/gmock.h>

namespace penumbra::spirv {
namespace {

using testing::ElementsAre;

Module with_header(std::initializer_list<std::uint32_t> instructions) {
  Module module{spv::MagicNumber, 0x10300, 0, 9, 0};
  module.insert(module.end(), instructions);
  return module;
}

constexpr std::uint32_t op(spv::Op opcode, std::uint32_t words) {
  return words << 16U | static_cast<std::uint32_t>(opcode);
}

std::vector<spv::Op> opcodes(const Module& module, bool whole = true) {
  std::vector<spv::Op> found;
  EXPECT_EQ(for_each_instruction(module, [&](Words words) { found.push_back(opcode(words)); }), whole);
  return found;
}

TEST(SpirvWords, AreInstructions) {
  EXPECT_THAT(opcodes(with_header({op(spv::OpTypeVoid, 2), 1, op(spv::OpTypeBool, 2), 2})),
              ElementsAre(spv::OpTypeVoid, spv::OpTypeBool));
  EXPECT_THAT(opcodes(with_header({})), ElementsAre());
  EXPECT_THAT(opcodes({}), ElementsAre());
}

TEST(SpirvWords, OfNoModuleEndTheWalk) {
  EXPECT_THAT(opcodes(with_header({op(spv::OpNop, 1), 0}), false), ElementsAre(spv::OpNop));
  EXPECT_THAT(opcodes(with_header({op(spv::OpNop, 1), op(spv::OpTypeInt, 4), 1}), false),
              ElementsAre(spv::OpNop));
  EXPECT_THAT(opcodes(with_header({0xFFFF0000U}), false), ElementsAre());
}

TEST(SpirvWords, MayBeWrittenInPlace) {
  Module module = with_header({op(spv::OpTypeVoid, 2), 1});
  for_each_instruction(module, [](WrittenWords words) { words[1] = 7; });
  EXPECT_EQ(module.back(), 7U);
}

TEST(SpirvWords, CanBeLeftOut) {
  const Module module =
      with_header({op(spv::OpTypeVoid, 2), 1, op(spv::OpNop, 1), op(spv::OpTypeBool, 2), 2});
  const auto no_nop = [](Words words) { return opcode(words) != spv::OpNop; };
  EXPECT_EQ(with_instructions(module, no_nop),
            with_header({op(spv::OpTypeVoid, 2), 1, op(spv::OpTypeBool, 2), 2}));
  const Module broken = with_header({op(spv::OpNop, 1), 0});
  EXPECT_EQ(with_instructions(broken, no_nop), broken) << "left to who says what is wrong with it";
  EXPECT_EQ(with_instructions({1, 2}, no_nop), (Module{1, 2}));
}

TEST(SpirvWords, HoldTextsOfFourBytesAWord) {
  EXPECT_EQ(literal_text(std::vector<std::uint32_t>{0x64636261, 0x65}), "abcde");
  EXPECT_EQ(literal_text(std::vector<std::uint32_t>{0x64636261}), "abcd") << "without an end";
  EXPECT_EQ(literal_text({}), "");
}

}  // namespace
}  // namespace penumbra::spirv
