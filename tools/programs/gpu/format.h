// The texel formats that shadow techniques need: for shadow maps, for computed values (moments, penumbra
// widths, masks) and for counts.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace penumbra::gpu {

// Numbers without a letter are fractions from 0 to 1, f are floats, ui unsigned integers. depth24 is 32 bits
// per texel in memory, depth in the low 24, the rest zero. depth32s8 is depth32 with 8 bits of stencil, which
// passes alone see: shaders and copies have its depth.
enum class Format {
  depth16,
  depth24,
  depth32,
  depth32s8,
  r8,
  rg8,
  rgba8,
  r16,
  rg16,
  rgba16,
  r16f,
  rg16f,
  rgba16f,
  r32f,
  rg32f,
  rgba32f,
  r11g11b10f,
  r8ui,
  r16ui,
  r32ui,
  rg32ui,
  rgba32ui
};

std::span<const Format> all_formats();

bool is_depth(Format format);
bool has_stencil(Format format);
bool is_integer(Format format);          // shaders read and write whole numbers
std::size_t texel_bytes(Format format);  // bytes in a copy
const char* name(Format format);
std::optional<Format> find_format(std::string_view name);

// The operations of a device on a format; copies to and from the host are always possible. They are not
// Vulkan's promises for every device: r11g11b10f, for example, is written by compute shaders on some.
struct FormatUses {
  bool sampled = false;   // shaders load texels
  bool filtered = false;  // linear samplers
  bool storage = false;   // compute shaders write texels
  bool target = false;    // passes draw into it
  bool blended = false;
  int most_samples = 1;  // for a target
};

}  // namespace penumbra::gpu
