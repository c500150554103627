// Works a program out.
#pragma once

#include <cstdint>
#include <vector>

#include "programs/program.h"

namespace penumbra::programs {

// The kOutputs words that the program stores, zero where it stores nothing. Throws Unfit (arithmetic.h) where
// the language leaves open what happens or where floats would have to be rounded.
std::vector<std::uint32_t> run(const Program& program, const std::vector<std::uint32_t>& inputs);

}  // namespace penumbra::programs
