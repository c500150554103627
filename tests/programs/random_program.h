// Makes a random program, the same for the same seed.
#pragma once

#include <cstdint>
#include <string>

#include "programs/program.h"

namespace penumbra::programs {

// `prefix` begins its names at file scope, so that many programs fit into one text.
Program random_program(std::uint32_t seed, const std::string& prefix);

}  // namespace penumbra::programs
