#include "lint/inline_sampler.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace penumbra::lint {

bool is_inline_sampler(std::string_view name) {
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto has = [&](const char* word) { return lower.find(word) != std::string::npos; };
  const bool filter = has("point") || has("linear");  // trilinear holds linear
  const bool wrap = has("clamp") || has("repeat") || has("mirror");
  return filter && wrap;
}

}  // namespace penumbra::lint
