// What a user's function may not do though it compiles: drivers crash on it, or its results mean nothing.
// Internal to this room.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace penumbra::resolve {

// `unoptimised`: its module before optimisation, with debug lines. Throws InputError, naming the line or else
// the shader, for a comparison through a sampler that does not compare and for other reads through one that
// does, and for `discard` and `clip`.
void check_adapter(std::vector<std::uint32_t> unoptimised, const std::string& shader);

}  // namespace penumbra::resolve
