// The settings that Unity derives from a sampler's name (Unity manual, "Using sampler states", inline sampler
// states): keywords in any case and order.
#pragma once

#include <string_view>

namespace penumbra::hlsl {

struct SamplerName {
  bool point = false;
  bool linear = false;  // trilinear contains "linear"
  bool clamp = false;
  bool repeat = false;
  bool mirror = false;
  bool compare = false;
};

SamplerName read_sampler_name(std::string_view name);

}  // namespace penumbra::hlsl
