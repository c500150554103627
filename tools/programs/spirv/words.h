// The instructions of a SPIR-V module, one after the other.
#pragma once

#include <cstddef>
#include <glslang/SPIRV/spirv.hpp>
#include <span>
#include <string>

#include "spirv/module.h"

namespace penumbra::spirv {

using Words = std::span<const std::uint32_t>;
using WrittenWords = std::span<std::uint32_t>;

constexpr std::size_t header_words = 5;

inline spv::Op opcode(Words instruction) {
  return static_cast<spv::Op>(instruction[0] & 0xFFFFU);
}

// Returns word `number` of the instruction; 0 where it is shorter.
inline std::uint32_t operand(Words instruction, std::size_t number) {
  return number < instruction.size() ? instruction[number] : 0;
}

// Returns a literal string, up to the NUL that ends it.
inline std::string literal_text(Words words) {
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

// Calls visit(Words) for each instruction after the header, or visit(WrittenWords) if the module is not
// const. Returns false and stops where the words are malformed.
template <typename SomeModule, typename Visit>
bool for_each_instruction(SomeModule& module, Visit visit) {
  for (std::size_t at = header_words; at < module.size();) {
    const std::size_t length = module[at] >> 16U;
    if (length == 0 || length > module.size() - at) return false;
    visit(std::span(module).subspan(at, length));
    at += length;
  }
  return true;
}

// Returns the instructions for which `keep(Words)` is true; the module itself if its words are malformed.
template <typename Keep>
Module with_instructions(const Module& module, Keep keep) {
  if (module.size() < header_words) return module;
  Module kept(module.begin(), module.begin() + header_words);
  kept.reserve(module.size());
  const bool whole = for_each_instruction(module, [&](Words instruction) {
    if (keep(instruction)) kept.insert(kept.end(), instruction.begin(), instruction.end());
  });
  return whole ? kept : module;
}

}  // namespace penumbra::spirv
