// Draws a small fragment shader on the device, with or without the preparation stage.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

namespace penumbra::preparation {

inline constexpr int kDrawnSize = 4;  // side of the picture and of every texture, in both directions

using Pixel = std::array<float, 4>;

// `body` defines `float4 Main(float4 p : SV_Position) : SV_Target`. Whatever it reads is given by name:
// - a texture not named below holds (number + 4y + x, x, y, number), its number being the one in `textures`;
// - a texture whose name holds "Depth" is a depth texture of (4y + x) / 16;
// - a sampler takes the nearest texel, or compares with <= when its name holds "Compare".
struct Drawing {
  std::string body;
  std::map<std::string, float> textures{};
  std::map<std::string, std::vector<float>> uniforms{};
  std::map<std::string, std::vector<float>> buffers{};
};

inline Pixel texel(float number, int x, int y) {
  return {number + static_cast<float>(4 * y + x), static_cast<float>(x), static_cast<float>(y), number};
}

// The picture, row by row. Throws with the messages when the shader does not compile or the device complains.
std::vector<Pixel> draw_prepared(const Drawing& drawing);
std::vector<Pixel> draw_unprepared(const Drawing& drawing);
std::vector<Pixel> draw_by_fxc(const Drawing& drawing);  // from FXC's bytecode

// The answer of `answer(x, y)` for every pixel.
template <typename Answer>
std::vector<Pixel> picture(Answer answer) {
  std::vector<Pixel> pixels;
  for (int y = 0; y < kDrawnSize; ++y)
    for (int x = 0; x < kDrawnSize; ++x) pixels.push_back(answer(x, y));
  return pixels;
}

}  // namespace penumbra::preparation
