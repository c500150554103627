#include "shaders/remainders.h"

#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

bool has_remainders(const SpirvModule& module) {
  bool found = false;
  spirv::for_each_instruction(module, [&](spirv::Words instruction) {
    found = found || spirv::opcode(instruction) == spv::OpFMod || spirv::opcode(instruction) == spv::OpSMod;
  });
  return found;
}

void append(SpirvModule& to, spv::Op op, std::uint32_t type, std::uint32_t result, std::uint32_t a,
            std::uint32_t b) {
  to.insert(to.end(), {5U << 16U | static_cast<std::uint32_t>(op), type, result, a, b});
}

}  // namespace

void truncate_remainders(SpirvModule& module) {
  if (!has_remainders(module)) return;
  SpirvModule result(module.begin(), module.begin() + spirv::header_words);
  spirv::for_each_instruction(module, [&](spirv::Words instruction) {
    if (spirv::opcode(instruction) == spv::OpSMod && instruction.size() == 5) {
      const std::uint32_t type = instruction[1];
      const std::uint32_t a = instruction[3];
      const std::uint32_t b = instruction[4];
      const std::uint32_t quotient = result[3]++;
      const std::uint32_t product = result[3]++;
      append(result, spv::OpSDiv, type, quotient, a, b);
      append(result, spv::OpIMul, type, product, b, quotient);
      append(result, spv::OpISub, type, instruction[2], a, product);
      return;
    }
    result.insert(result.end(), instruction.begin(), instruction.end());
    if (spirv::opcode(instruction) == spv::OpFMod)
      result[result.size() - instruction.size()] =
          static_cast<std::uint32_t>(instruction.size()) << 16U | spv::OpFRem;
  });
  module = std::move(result);
}

}  // namespace penumbra::shaders
