// PNG with 16 bits a channel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace penumbra::bake {

// The picture has width * height * channels samples, rows from the bottom, as in Unity's textures; 1 channel
// is grey, 4 are RGBA. The same samples give the same bytes. Throws std::invalid_argument where the samples
// do not fit.
std::vector<std::byte> encode_png_16(int width, int height, int channels,
                                     std::span<const std::uint16_t> samples);

}  // namespace penumbra::bake
