// Computes the alpha of cut-outs anew in long double, and makes sheets that carry them.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

#include "scene/scene.h"

namespace penumbra::scene {

using LongVec2 = glm::vec<2, long double>;

inline long double distance_to_whole(long double x) {
  return std::abs(x - std::nearbyint(x));
}

inline long double exact_pattern(AlphaPattern pattern, const LongVec2& uv) {
  long double alpha = 1.0L;
  // The coordinates are from the square's centre, -1/2 .. 1/2.
  const LongVec2 centred(uv.x - std::floor(uv.x) - 0.5L, uv.y - std::floor(uv.y) - 0.5L);
  if (pattern == AlphaPattern::wire_grid) {
    alpha = 1.0L - std::min(distance_to_whole(uv.x), distance_to_whole(uv.y)) / 0.125L;
  } else if (pattern == AlphaPattern::leaf) {
    alpha = 0.5L + 4.0L * (0.25L - centred.x * centred.x - std::abs(centred.y));
  } else if (pattern == AlphaPattern::holes) {
    alpha = 0.5L + 4.0L * (std::hypot(centred.x, centred.y) - 0.375L);
  } else if (pattern == AlphaPattern::wire) {
    alpha = 4.5L - 24.0L * std::abs(centred.y);
  } else if (pattern == AlphaPattern::smoke) {
    const long double edge = std::max(0.25L - centred.x * centred.x - centred.y * centred.y, 0.0L);
    alpha = 9.6L * edge * edge;
  }
  return std::clamp(alpha, 0.0L, 1.0L);
}

inline int wrapped_texel(int texel, int size, TextureWrap wrap) {
  if (wrap == TextureWrap::clamp) return std::clamp(texel, 0, size - 1);
  const int period = wrap == TextureWrap::repeat ? size : 2 * size;
  const int within = ((texel % period) + period) % period;
  return within < size ? within : 2 * size - 1 - within;
}

// The alpha is the sum over all texels of a tent's weight, not the mixture of four.
inline long double exact_texture(const Texture& texture, const CutOut& cut_out, const LongVec2& uv) {
  const long double x = uv.x * texture.width - 0.5L, y = uv.y * texture.height - 0.5L;
  const std::size_t channel = cut_out.channel == TextureChannel::alpha ? 3 : 0;
  long double sum = 0.0L;
  for (int row = int(std::floor(y)) - 1; row <= int(std::floor(y)) + 2; ++row) {
    for (int column = int(std::floor(x)) - 1; column <= int(std::floor(x)) + 2; ++column) {
      const long double weight =
          std::max(0.0L, 1.0L - std::abs(x - column)) * std::max(0.0L, 1.0L - std::abs(y - row));
      const auto at =
          static_cast<std::size_t>(wrapped_texel(row, texture.height, cut_out.wrap_v) * texture.width +
                                   wrapped_texel(column, texture.width, cut_out.wrap_u));
      sum += weight * texture.rgba[4 * at + channel] / 255.0L;
    }
  }
  return sum;
}

inline long double exact_alpha(const Scene& scene, const CutOut& cut_out, const LongVec2& uv) {
  long double alpha = cut_out.factor * exact_pattern(cut_out.pattern, uv);
  if (cut_out.texture >= 0) alpha *= exact_texture(scene.textures[std::size_t(cut_out.texture)], cut_out, uv);
  return alpha;
}

// The sides are odd, and the blocks have every grey: no two texels that a wrong index would mistake for each
// other are equal.
inline Texture odd_texture() {
  Texture texture{5, 3, {}};
  for (int texel = 0; texel < 15; ++texel) {
    const auto alpha = static_cast<std::uint8_t>((texel * 97 + 31) % 256);
    const auto red = static_cast<std::uint8_t>((texel * 61 + 200) % 256);
    texture.rgba.insert(texture.rgba.end(), {red, 0, 255, alpha});
  }
  return texture;
}

// These cut-outs are drawn and asked everywhere.
struct NamedCutOut {
  const char* name;
  CutOut cut_out;
};
inline std::vector<NamedCutOut> cut_outs_of_all_kinds() {
  const auto texture = [](TextureWrap u, TextureWrap v, TextureChannel channel, float factor) {
    return CutOut{AlphaPattern::none, 0, channel, u, v, factor, 0.5F};
  };
  return {{"wire grid", {.pattern = AlphaPattern::wire_grid}},
          {"thin wire grid", {.pattern = AlphaPattern::wire_grid, .cutoff = 0.75F}},
          {"leaf", {.pattern = AlphaPattern::leaf}},
          {"holes", {.pattern = AlphaPattern::holes}},
          {"holes of half alpha", {.pattern = AlphaPattern::holes, .factor = 0.5F, .cutoff = 0.3F}},
          {"wire", {.pattern = AlphaPattern::wire}},
          {"smoke", {.pattern = AlphaPattern::smoke, .cutoff = 0.3F}},
          {"repeat", texture(TextureWrap::repeat, TextureWrap::repeat, TextureChannel::alpha, 1.0F)},
          {"mirror and clamp", texture(TextureWrap::mirror, TextureWrap::clamp, TextureChannel::alpha, 1.0F)},
          {"clamp and mirror", texture(TextureWrap::clamp, TextureWrap::mirror, TextureChannel::red, 0.9F)},
          {"repeat and clamp", texture(TextureWrap::repeat, TextureWrap::clamp, TextureChannel::red, 0.8F)}};
}

// Adds a material of its own for what is added after this; textures[0] is odd_texture().
inline std::uint16_t add_cut_out(Scene& scene, const CutOut& cut_out) {
  if (scene.textures.empty()) scene.textures.push_back(odd_texture());
  Material material;
  material.name = "cut out";
  material.cut_out = cut_out;
  scene.materials.push_back(std::move(material));
  return static_cast<std::uint16_t>(scene.materials.size() - 1);
}

}  // namespace penumbra::scene
