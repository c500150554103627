#include "hlsl/sampler_name.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace penumbra::hlsl {

SamplerName read_sampler_name(std::string_view name) {
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto has = [&lower](const char* word) { return lower.find(word) != std::string::npos; };
  return {has("point"), has("linear"), has("clamp"), has("repeat"), has("mirror"), has("compare")};
}

}  // namespace penumbra::hlsl
