// Makes random sources full of macros, conditions and comments.
#pragma once

#include <cstdint>
#include <string>

namespace penumbra::preprocessing {

// The source is the same for the same seed on every machine. Most are free of errors.
std::string random_macros(std::uint32_t seed);

}  // namespace penumbra::preprocessing
