#include "preparation/resource_types.h"

#include <map>

#include "hlsl/name_set.h"

namespace penumbra::preparation {

namespace {

std::string_view without(std::string_view type, std::string_view prefix) {
  return type.substr(0, prefix.size()) == prefix ? type.substr(prefix.size()) : type;
}

}  // namespace

bool is_texture(std::string_view type) {
  static constexpr hlsl::NameSet textures("Texture1D", "Texture1DArray", "Texture2D", "Texture2DArray",
                                          "Texture3D", "TextureCube", "TextureCubeArray", "Texture2DMS",
                                          "Texture2DMSArray");
  return textures.contains(without(without(type, "RasterizerOrdered"), "RW"));
}

bool is_sampler(std::string_view type) {
  static constexpr hlsl::NameSet samplers("SamplerState", "SamplerComparisonState", "sampler", "sampler1D",
                                          "sampler2D", "sampler3D", "samplerCUBE");
  return samplers.contains(type);
}

bool is_buffer(std::string_view type) {
  static constexpr hlsl::NameSet buffers("StructuredBuffer", "ByteAddressBuffer", "AppendStructuredBuffer",
                                         "ConsumeStructuredBuffer");
  return buffers.contains(without(without(type, "RasterizerOrdered"), "RW"));
}

bool is_resource(std::string_view type) {
  return is_texture(type) || is_sampler(type) || is_buffer(type) || type == "Buffer" || type == "RWBuffer";
}

}  // namespace penumbra::preparation
