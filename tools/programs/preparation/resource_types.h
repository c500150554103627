// HLSL's types for resources, by name. Internal to this folder.
#pragma once

#include <set>

#include "preparation/value_types.h"

namespace penumbra::preparation {

bool is_texture(std::string_view type);  // Texture2D, RWTexture3D, ...
bool is_sampler(std::string_view type);  // SamplerState, SamplerComparisonState, sampler, sampler2D, ...
bool is_buffer(
    std::string_view type);  // StructuredBuffer, ByteAddressBuffer, ...: buffers with a memory layout

bool is_resource(std::string_view type);  // any of these types, and Buffer

}  // namespace penumbra::preparation
