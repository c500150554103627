#include "preparation/texture_precision.h"

#include <string_view>

#include "hlsl/name_set.h"

namespace penumbra::preparation {

namespace {

constexpr hlsl::NameSet typed("Texture2D", "Texture2DArray", "Texture3D", "TextureCube", "TextureCubeArray",
                              "Texture2DMS", "sampler2D", "sampler3D", "samplerCUBE", "sampler",
                              "SamplerState", "sampler1D");

// Returns the type without its precision; empty if the identifier is not such a type.
std::string_view plain_type(std::string_view word) {
  for (const std::string_view suffix : {std::string_view("_half"), std::string_view("_float")}) {
    if (word.size() <= suffix.size() || word.substr(word.size() - suffix.size()) != suffix) continue;
    const std::string_view stem = word.substr(0, word.size() - suffix.size());
    if (typed.contains(stem)) return stem;
  }
  return {};
}

}  // namespace

void drop_texture_precision(TokenText& text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char lead = text.lead(at);
    if (lead != 'T' && lead != 's' && lead != 'S') continue;  // all of them begin with one of these
    const std::string_view plain = plain_type(text[at].spelling);
    if (!plain.empty()) text.replace(at, 1, plain);
  }
  text.apply();
}

}  // namespace penumbra::preparation
