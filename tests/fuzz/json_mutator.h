// Mutations for targets whose inputs are JSON.
#pragma once

#include <cstddef>
#include <cstdint>

namespace penumbra::fuzz {

// Mutates as LLVMFuzzerCustomMutator (libFuzzer) does: it changes the data in place, to at most `most` bytes,
// and returns their number. One in eight mutants, and those of what is no JSON, are libFuzzer's own.
std::size_t mutate_json(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed);

}  // namespace penumbra::fuzz
