#include "lighting/texture_pyramid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "input/input_error.h"
#include "lighting/tone_curve.h"

namespace penumbra::lighting {
namespace {

std::array<float, 256> meaning_of_bytes(TexelMeaning meaning) {
  std::array<float, 256> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float share = static_cast<float>(i) / 255.0F;
    values[i] = meaning == TexelMeaning::srgb_colour ? srgb_decoded(share) : 2.0F * share - 1.0F;
  }
  return values;
}

int wrapped(int texel, int count) {
  const int rest = texel % count;
  return rest < 0 ? rest + count : rest;
}

}  // namespace

TexturePyramid::TexturePyramid(const scene::Texture& texture, TexelMeaning meaning) {
  const std::size_t texels = static_cast<std::size_t>(std::max(texture.width, 0)) *
                             static_cast<std::size_t>(std::max(texture.height, 0));
  if (texels == 0 || texture.rgba.size() != 4 * texels) {
    throw InputError("", "a texture does not hold width x height texels");
  }
  const std::array<float, 256> values = meaning_of_bytes(meaning);
  Level level{texture.width, texture.height, {}};
  level.texels.reserve(texels);
  for (std::size_t i = 0; i < 4 * texels; i += 4) {
    level.texels.emplace_back(values[texture.rgba[i]], values[texture.rgba[i + 1]],
                              values[texture.rgba[i + 2]]);
  }
  levels_.push_back(std::move(level));
  while (levels_.back().texels.size() > 1) levels_.push_back(halved(levels_.back()));
}

TexturePyramid::Level TexturePyramid::halved(const Level& level) {
  Level half{(level.width + 1) / 2, (level.height + 1) / 2, {}};
  half.texels.reserve(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
  const auto texel = [&](int x, int y) {
    return level.texels[static_cast<std::size_t>(std::min(y, level.height - 1)) *
                            static_cast<std::size_t>(level.width) +
                        static_cast<std::size_t>(std::min(x, level.width - 1))];
  };
  for (int y = 0; y < level.height; y += 2) {
    for (int x = 0; x < level.width; x += 2) {
      half.texels.push_back((texel(x, y) + texel(x + 1, y) + texel(x, y + 1) + texel(x + 1, y + 1)) * 0.25F);
    }
  }
  return half;
}

glm::vec3 TexturePyramid::Level::read(const glm::vec2& uv) const {
  const glm::vec2 place = (uv - glm::floor(uv)) * glm::vec2(float(width), float(height)) - 0.5F;
  const glm::vec2 low = glm::floor(place);
  const glm::vec2 share = place - low;
  const auto texel = [&](int x, int y) {
    return texels[static_cast<std::size_t>(wrapped(y, height)) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(wrapped(x, width))];
  };
  const int x = static_cast<int>(low.x);
  const int y = static_cast<int>(low.y);
  return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), share.x),
                  glm::mix(texel(x, y + 1), texel(x + 1, y + 1), share.x), share.y);
}

glm::vec3 TexturePyramid::read(const glm::vec2& uv, float footprint_uv) const {
  const Level& finest = levels_.front();
  const float texels = footprint_uv * std::sqrt(float(finest.width) * float(finest.height));
  const float level = std::clamp(std::log2(std::max(texels, 1.0F)), 0.0F, float(levels_.size() - 1));
  const auto fine = static_cast<std::size_t>(level);
  const float share = level - float(fine);
  if (share == 0.0F) return levels_[fine].read(uv);
  return glm::mix(levels_[fine].read(uv), levels_[fine + 1].read(uv), share);
}

}  // namespace penumbra::lighting
