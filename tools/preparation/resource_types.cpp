#include "preparation/resource_types.h"

#include <algorithm>
#include <array>
#include <map>

namespace penumbra::preparation {

namespace {

template <std::size_t Size>
bool among(std::string_view word, const std::array<std::string_view, Size>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string_view without(std::string_view type, std::string_view prefix) {
  return type.substr(0, prefix.size()) == prefix ? type.substr(prefix.size()) : type;
}

}  // namespace

bool is_texture(std::string_view type) {
  constexpr std::array<std::string_view, 9> textures{
      "Texture1D",   "Texture1DArray",   "Texture2D",   "Texture2DArray",  "Texture3D",
      "TextureCube", "TextureCubeArray", "Texture2DMS", "Texture2DMSArray"};
  return among(without(without(type, "RasterizerOrdered"), "RW"), textures);
}

bool is_sampler(std::string_view type) {
  constexpr std::array<std::string_view, 7> samplers{
      "SamplerState", "SamplerComparisonState", "sampler", "sampler1D", "sampler2D", "sampler3D",
      "samplerCUBE"};
  return among(type, samplers);
}

bool is_buffer(std::string_view type) {
  constexpr std::array<std::string_view, 4> buffers{"StructuredBuffer", "ByteAddressBuffer",
                                                    "AppendStructuredBuffer", "ConsumeStructuredBuffer"};
  return among(without(without(type, "RasterizerOrdered"), "RW"), buffers);
}

bool is_resource(std::string_view type) {
  return is_texture(type) || is_sampler(type) || is_buffer(type) || type == "Buffer" || type == "RWBuffer";
}

std::set<std::string_view> structs_with_resources(const ValueTypes& types) {
  std::set<std::string_view> found;
  // A struct stands after those it is made of: one round finds them all, in the order of the text.
  std::map<std::size_t, std::string_view> in_order;
  for (const auto& [name, type] : types.structs()) in_order.emplace(type.declaration, name);
  for (const auto& [declaration, name] : in_order) {
    const StructType& type = types.structs().at(name);
    const bool holds = std::any_of(type.members.begin(), type.members.end(), [&](std::size_t member) {
      const std::string_view of = types.declared()[member].type.name;
      return is_resource(of) || found.count(of) != 0;
    });
    if (holds || found.count(type.base) != 0) found.insert(name);
  }
  return found;
}

}  // namespace penumbra::preparation
