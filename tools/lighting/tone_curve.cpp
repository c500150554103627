#include "lighting/tone_curve.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace penumbra::lighting {
namespace {

constexpr float kMost = 1e6F;  // what is brighter is white all the same

float usable(float channel) {
  return channel > 0.0F ? std::min(channel, kMost) : 0.0F;  // NaN is not above 0
}

}  // namespace

glm::vec3 tone_mapped(const glm::vec3& light) {
  constexpr float kMirrored = 0.04F;
  constexpr float kStart = 0.8F - kMirrored;
  constexpr float kDesaturation = 0.15F;
  glm::vec3 colour(usable(light.r), usable(light.g), usable(light.b));
  const float least = std::min({colour.r, colour.g, colour.b});
  colour -= least < 2.0F * kMirrored ? least - 6.25F * least * least : kMirrored;
  const float peak = std::max({colour.r, colour.g, colour.b});
  if (peak < kStart) return glm::max(colour, glm::vec3(0.0F));
  constexpr float kRange = 1.0F - kStart;
  const float compressed = 1.0F - kRange * kRange / (peak + kRange - kStart);
  const float to_white = 1.0F - 1.0F / (kDesaturation * (peak - compressed) + 1.0F);
  return glm::clamp(glm::mix(colour * (compressed / peak), glm::vec3(compressed), to_white), 0.0F, 1.0F);
}

float srgb_encoded(float linear) {
  const float value = std::clamp(linear, 0.0F, 1.0F);
  return value <= 0.0031308F ? 12.92F * value : 1.055F * std::pow(value, 1.0F / 2.4F) - 0.055F;
}

float srgb_decoded(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

}  // namespace penumbra::lighting
