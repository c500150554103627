#include "lighting/tone_curve.h"

#include <algorithm>
#include <cmath>

namespace penumbra::lighting {
namespace {

constexpr float kLinearStart = 0.22F;                                      // m
constexpr float kLinearEnd = kLinearStart + (1.0F - kLinearStart) * 0.4F;  // m + l0, of l = 0.4
constexpr float kToe = 1.33F;                                              // c

float channel_mapped(float light) {
  if (!(light > 0.0F)) return 0.0F;  // NaN is not above 0
  if (light > kLinearEnd) {
    return 1.0F - (1.0F - kLinearEnd) * std::exp(-(light - kLinearEnd) / (1.0F - kLinearEnd));
  }
  if (light >= kLinearStart) return light;
  const float share = light / kLinearStart;
  const float toe = kLinearStart * std::pow(share, kToe);
  return std::lerp(toe, light, share * share * (3.0F - 2.0F * share));
}

}  // namespace

glm::vec3 tone_mapped(const glm::vec3& light) {
  return {channel_mapped(light.r), channel_mapped(light.g), channel_mapped(light.b)};
}

float srgb_encoded(float linear) {
  const float value = std::clamp(linear, 0.0F, 1.0F);
  return value <= 0.0031308F ? 12.92F * value : 1.055F * std::pow(value, 1.0F / 2.4F) - 0.055F;
}

float srgb_decoded(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

}  // namespace penumbra::lighting
