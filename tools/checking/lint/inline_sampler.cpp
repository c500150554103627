#include "lint/inline_sampler.h"

#include "hlsl/sampler_name.h"

namespace penumbra::lint {

bool is_inline_sampler(std::string_view name) {
  const hlsl::SamplerName words = hlsl::read_sampler_name(name);
  return (words.point || words.linear) && (words.clamp || words.repeat || words.mirror);
}

}  // namespace penumbra::lint
