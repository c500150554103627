// A module's instructions one after the other, as words. Internal to this room.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glslang/SPIRV/spirv.hpp>
#include <span>
#include <string>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

constexpr std::size_t header_words = 5;

using SpirvWords = std::span<const std::uint32_t>;

inline spv::Op opcode(SpirvWords instruction) {
  return static_cast<spv::Op>(instruction[0] & 0xFFFFU);
}

// A literal string, up to the NUL that ends it.
inline std::string literal_text(SpirvWords words) {
  std::string text;
  for (const std::uint32_t word : words) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
      const auto character = static_cast<char>((word >> shift) & 0xFFU);
      if (character == '\0') return text;
      text += character;
    }
  }
  return text;
}

// visit(SpirvWords) for each instruction behind the header. Ends where the words are those of no module.
template <typename Visit>
void for_each_instruction(const SpirvModule& module, Visit visit) {
  for (std::size_t at = header_words; at < module.size();) {
    const std::size_t length = module[at] >> 16U;
    if (length == 0 || at + length > module.size()) return;
    visit(SpirvWords(module).subspan(at, length));
    at += length;
  }
}

}  // namespace penumbra::shaders
