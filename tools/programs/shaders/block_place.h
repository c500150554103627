// What a pointer into a block points to, counted in words of 32 bits. Internal to this room.
#pragma once

#include <cstdint>
#include <vector>

#include "shaders/block_types.h"

namespace penumbra::shaders {

constexpr std::uint32_t word_bytes = 4;

struct BlockPlace {
  struct Term {
    std::uint32_t index;  // the id of a number known at run time
    std::uint32_t words;
  };
  std::uint32_t variable = 0;  // of the block
  BlockMember value;           // its offset is not used
  std::uint32_t word = 0;
  std::uint32_t component_words = 1;  // from one component of a vector to the next
  std::vector<Term> terms;            // index times words are added to `word`
};

// Moves into part `number` of the value; false where it has no such part or one that does not lie on a word.
bool enter_part(BlockPlace& place, const BlockTypes& types, std::uint32_t number);

// The same for a number known at run time.
bool enter_part_at(BlockPlace& place, const BlockTypes& types, std::uint32_t index);

// Words from one part of a value to the next; not for structs.
std::uint32_t part_stride(const BlockPlace& place, const BlockTypes& types);

// Components, columns, elements or members.
std::uint32_t part_count(const BlockType& type);

// Of a value of at most `most` words, all of them numbers of 32 bits, how many; else more than `most`.
std::uint32_t word_count(const BlockPlace& place, const BlockTypes& types, std::uint32_t most);

}  // namespace penumbra::shaders
