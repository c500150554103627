// Blocks that a target's own layout rules cannot express, as arrays of words. HLSL packs a cbuffer into
// registers of four words wherever a member fits: `float a; float2 b;` puts b at byte 4, where GL's std140
// wants 8, and a member may lie behind the last element of an array. GLSL before 4.40 and ESSL have no
// offsets to say so, and no version may move a member forward.
//
// Such a block becomes `uvec4 words[N]`, a storage buffer `uint words[]`, and every read and write takes the
// words that the member has, with a bit cast. Whoever fills the buffer fills the same bytes: names, bindings,
// offsets and sizes stay those of the module (reflect.h).
#pragma once

#include <optional>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// not_for_gl: that are neither std140 nor, of storage buffers, std430. not_for_vulkan: uniform blocks with a
// member in what an array or struct before it leaves free, which is valid for no SPIR-V.
enum class BlocksAsWords { not_for_gl, not_for_vulkan };

// The module with those blocks as words. Nothing where
// there is none, or where one is used in a way that words do not serve: atomics on a member, numbers that are
// not of 32 bits. The module must be legalised.
std::optional<SpirvModule> with_word_blocks(const SpirvModule& module, BlocksAsWords which);

}  // namespace penumbra::shaders
