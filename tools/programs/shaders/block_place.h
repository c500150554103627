// The part of a block that a pointer refers to, in words of 32 bits. Internal to this folder.
#pragma once

#include <cstdint>
#include <vector>

#include "shaders/block_types.h"

namespace penumbra::shaders {

constexpr std::uint32_t word_bytes = 4;

struct BlockPlace {
  struct Term {
    std::uint32_t index;  // the id of a value known only at run time
    std::uint32_t words;
  };
  std::uint32_t variable = 0;  // the block's variable
  BlockMember value;           // its offset is not used
  std::uint32_t word = 0;
  std::uint32_t component_words = 1;  // words from one component of a vector to the next
  std::vector<Term> terms;            // index times words are added to `word`
};

// Selects part `number` of the value; returns false if it has no such part or one that is not aligned to a
// word.
bool enter_part(BlockPlace& place, const BlockTypes& types, std::uint32_t number);

// Selects the same for a dynamic index.
bool enter_part_at(BlockPlace& place, const BlockTypes& types, std::uint32_t index);

// Returns the stride from one part of a value to the next, in words; not for structs.
std::uint32_t part_stride(const BlockPlace& place, const BlockTypes& types);

// Returns the number of components, columns, elements or members.
std::uint32_t part_count(const BlockType& type);

// Returns the number of words of a value that consists of 32-bit numbers, if it is at most `most`; else more
// than `most`.
std::uint32_t word_count(const BlockPlace& place, const BlockTypes& types, std::uint32_t most);

}  // namespace penumbra::shaders
