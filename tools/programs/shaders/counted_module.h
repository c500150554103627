// A module that counts the texels and bytes that it reads and writes, its scalar operations and barriers.
//
// It computes what the shipped module does, and its counts for each invocation. It is derived from the
// compiler's module before optimisation, so a fetch counts where the source reaches it, even if the optimiser
// would remove it; then it is optimised like the shipped module.
//
// Fetches: 1 for every sample, gather, load and read of a texture, in any function. A Buffer<> is a texture
// in SPIR-V; structured, raw and constant buffers, groupshared memory and queries of a texture's size or
// level of detail count 0. Texels written: 1 for each store to a writable texture, and 1 for each colour
// output of a fragment that is not discarded. An atomic operation on a texel counts as a fetch and as a texel
// written. Operations: those that an invocation executes, 1 for each scalar of a result of arithmetic,
// comparison, selection, conversion of numbers, bit operation or derivative, 1 also for a division, a root or
// another elementary function; 2 n - 1 for a dot product of n components, and so for each scalar of a product
// with a matrix; 1 for each scalar read from or written to groupshared memory, and for each atomic operation.
// Branches, calls, copies, texture and buffer accesses and barriers count 0. The optimiser and the driver
// leave fewer; a GPU executes them for all threads of a wave where one of them needs them.
//
// Bytes: those of the texels that an access names, by the format of its texture, which the host tells
// (texel_bytes_uniform()): of one texel for a load, a read, a store and an atomic operation, of four for a
// sample or a gather, whatever its sampler. So they are what shaders ask for, before any cache; structured,
// raw and constant buffers count 0 as above. All textures of a struct or an array count with the format of
// the one that was stored in it last. Barriers: 1 for each that an invocation passes.
//
// Limits: counts of fetches, of texels and of an invocation have 32 bits, the others 64. A discarded
// fragment's fetches count up to the discard. Colour outputs count whether or not a target is bound to them,
// and once for all samples of a pixel; depth does not count. Helper invocations count 0, and their atomic
// operations have no effect. If a fragment shader neither discards, nor sets its depth or coverage, nor
// writes anything but its outputs, only fragments that pass the depth test count: GPUs run that test before
// shading. For other fragment shaders, fragments that the depth test rejects also count.
#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "shaders/vulkan_version.h"
#include "spirv/module.h"

namespace penumbra::shaders {

// The storage buffer with the counts, by the name that reflection gives it: one that HLSL cannot declare.
//
// Its words: the width, height and depth of the grid of counts, each at least 1, the number of invocations,
// and their barriers, low word first; then for each cell of the grid, x first, the counts, to which every
// invocation adds its own: fetches, texels written, and of operations, bytes read and bytes written the low
// and the high word. The cell is a fragment's pixel, or a
// compute shader's SV_DispatchThreadID; an invocation outside of the grid adds to the nearest cell. So a grid
// of 1 x 1 x 1 has the totals of a draw or dispatch of any size.
inline constexpr const char* texel_counts_name = "$TexelCounts";
inline constexpr std::size_t texel_counts_header = 6;       // words before the counts
inline constexpr std::size_t texel_counts_invocations = 3;  // the word of the header
inline constexpr std::size_t texel_counts_barriers = 4;     // the same, the low word
inline constexpr std::size_t texel_counts_per_cell = 8;

// The uniform block with the bytes of a texel of each texture, and the name of its member, a uint, for the
// texture of that name. For the colour output of location N the texture's name is "SV_TargetN".
inline constexpr const char* texel_bytes_name = "$TexelBytes";
std::string texel_bytes_uniform(const std::string& texture);

// The function takes CompileResult::unoptimised. `entry` names its entry point, of a fragment or compute
// shader; the result has it, too, and has passed validation for `vulkan`. Throws std::invalid_argument for
// words that are not SPIR-V, another entry point or another stage; std::logic_error if the result is invalid.
// Instructions with the results `uncounted` are no operations.
spirv::Module counted_module(const spirv::Module& unoptimised, const std::string& entry,
                             VulkanVersion vulkan = VulkanVersion::v1_1,
                             const std::set<std::uint32_t>& uncounted = {});

}  // namespace penumbra::shaders
