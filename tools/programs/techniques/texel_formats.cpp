#include "techniques/texel_formats.h"

#include <algorithm>
#include <array>

namespace penumbra::techniques {
namespace {

constexpr std::array kFormats{TexelFormat{"depth16", "D16_UNorm", true},
                              TexelFormat{"depth24", "D24_UNorm", true},
                              TexelFormat{"depth32", "D32_SFloat", true},
                              TexelFormat{"depth32s8", "D32_SFloat_S8_UInt", true, false, true},
                              TexelFormat{"r8", "R8_UNorm"},
                              TexelFormat{"rg8", "R8G8_UNorm"},
                              TexelFormat{"rgba8", "R8G8B8A8_UNorm", false, true},
                              TexelFormat{"r16", "R16_UNorm"},
                              TexelFormat{"rg16", "R16G16_UNorm"},
                              TexelFormat{"rgba16", "R16G16B16A16_UNorm"},
                              TexelFormat{"r16f", "R16_SFloat"},
                              TexelFormat{"rg16f", "R16G16_SFloat"},
                              TexelFormat{"rgba16f", "R16G16B16A16_SFloat", false, true},
                              TexelFormat{"r32f", "R32_SFloat", false, true},
                              TexelFormat{"rg32f", "R32G32_SFloat"},
                              TexelFormat{"rgba32f", "R32G32B32A32_SFloat", false, true},
                              TexelFormat{"r11g11b10f", "B10G11R11_UFloatPack32"},
                              TexelFormat{"r8ui", "R8_UInt"},
                              TexelFormat{"r16ui", "R16_UInt"},
                              TexelFormat{"r32ui", "R32_UInt", false, true},
                              TexelFormat{"rg32ui", "R32G32_UInt"},
                              TexelFormat{"rgba32ui", "R32G32B32A32_UInt", false, true}};

}  // namespace

std::span<const TexelFormat> texel_formats() {
  return kFormats;
}

const TexelFormat* find_texel_format(std::string_view name) {
  const auto* found = std::find_if(kFormats.begin(), kFormats.end(),
                                   [name](const TexelFormat& format) { return format.name == name; });
  return found == kFormats.end() ? nullptr : found;
}

}  // namespace penumbra::techniques
