// Blocks that a target's layout rules cannot express, as arrays of words. HLSL packs a cbuffer into registers
// of four words wherever a member fits: `float a; float2 b;` puts b at byte 4, where GL's std140 requires 8,
// and a member may share the last register of an array. GLSL before 4.40 and ESSL have no explicit offsets,
// and no version allows an offset below the alignment.
//
// Such a block becomes `uvec4 words[N]`, a storage buffer `uint words[]`, and every read and write accesses
// the member's words with a bit cast. The bytes of the buffer do not change: names, bindings, offsets and
// sizes remain those of the module (reflect.h).
#pragma once

#include <optional>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// not_for_gl means blocks that are neither std140 nor, for storage buffers, std430. overlapping_in_gl means
// uniform blocks with a member in the padding of an array, struct or matrix before it, which explicit offsets
// of GLSL 4.40 do not allow either. not_for_vulkan means storage buffers that are not std430, which need
// VK_EXT_scalar_block_layout, and uniform blocks with a member in the padding of an array or struct before
// it, which is never valid SPIR-V.
enum class BlocksAsWords { not_for_gl, overlapping_in_gl, not_for_vulkan };

// Returns the module with those blocks as words, or nothing if there are none, or if one is used in a way
// that words do not support: atomics on a member, numbers that do not have 32 bits. The module must be
// legalised.
std::optional<SpirvModule> with_word_blocks(const SpirvModule& module, BlocksAsWords which);

}  // namespace penumbra::shaders
