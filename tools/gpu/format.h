// The texel formats this project needs: three of shadow maps, three of data.
#pragma once

#include <cstddef>

namespace penumbra::gpu {

// depth24 is 32 bits per texel in memory, depth in the low 24, the rest zero.
enum class Format { depth16, depth24, depth32, r32f, rg32f, rgba32f };

bool is_depth(Format format);
std::size_t texel_bytes(Format format);
const char* name(Format format);

}  // namespace penumbra::gpu
