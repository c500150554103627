#include "techniques/texel_formats.h"

#include <algorithm>
#include <array>

namespace penumbra::techniques {
namespace {

constexpr std::array kFormats{TexelFormat{"depth16", "D16_UNorm", 2, true},
                              TexelFormat{"depth24", "D24_UNorm", 4, true},
                              TexelFormat{"depth32", "D32_SFloat", 4, true},
                              TexelFormat{"depth32s8", "D32_SFloat_S8_UInt", 8, true, false, true},
                              TexelFormat{"r8", "R8_UNorm", 1},
                              TexelFormat{"rg8", "R8G8_UNorm", 2},
                              TexelFormat{"rgba8", "R8G8B8A8_UNorm", 4, false, true},
                              TexelFormat{"r16", "R16_UNorm", 2},
                              TexelFormat{"rg16", "R16G16_UNorm", 4},
                              TexelFormat{"rgba16", "R16G16B16A16_UNorm", 8},
                              TexelFormat{"r16f", "R16_SFloat", 2},
                              TexelFormat{"rg16f", "R16G16_SFloat", 4},
                              TexelFormat{"rgba16f", "R16G16B16A16_SFloat", 8, false, true},
                              TexelFormat{"r32f", "R32_SFloat", 4, false, true},
                              TexelFormat{"rg32f", "R32G32_SFloat", 8},
                              TexelFormat{"rgba32f", "R32G32B32A32_SFloat", 16, false, true},
                              TexelFormat{"r11g11b10f", "B10G11R11_UFloatPack32", 4},
                              TexelFormat{"r8ui", "R8_UInt", 1},
                              TexelFormat{"r16ui", "R16_UInt", 2},
                              TexelFormat{"r32ui", "R32_UInt", 4, false, true},
                              TexelFormat{"rg32ui", "R32G32_UInt", 8},
                              TexelFormat{"rgba32ui", "R32G32B32A32_UInt", 16, false, true}};

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
