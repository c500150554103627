#include "shaders/glsl_names.h"

#include <algorithm>
#include <iterator>

namespace penumbra::shaders {

namespace {

struct Names {
  std::string_view glsl;
  std::string_view hlsl;
};

constexpr Names names[] = {{"vec2", "float2"},
                           {"vec3", "float3"},
                           {"vec4", "float4"},
                           {"ivec2", "int2"},
                           {"ivec3", "int3"},
                           {"ivec4", "int4"},
                           {"uvec2", "uint2"},
                           {"uvec3", "uint3"},
                           {"uvec4", "uint4"},
                           {"bvec2", "bool2"},
                           {"bvec3", "bool3"},
                           {"bvec4", "bool4"},
                           {"mat2", "float2x2"},
                           {"mat3", "float3x3"},
                           {"mat4", "float4x4"},
                           {"sampler2DArray", "Texture2DArray"},
                           {"samplerCube", "TextureCube"},
                           {"dFdx", "ddx"},
                           {"dFdy", "ddy"},
                           {"floatBitsToInt", "asint"},
                           {"floatBitsToUint", "asuint"},
                           {"fract", "frac"},
                           {"intBitsToFloat", "asfloat"},
                           {"inversesqrt", "rsqrt"},
                           {"mix", "lerp"},
                           {"mod", "fmod"},
                           {"texelFetch", "Load"},
                           {"textureGrad", "SampleGrad"},
                           {"textureLod", "SampleLevel"},
                           {"uintBitsToFloat", "asfloat"}};

}  // namespace

std::string_view hlsl_name(std::string_view glsl) {
  const auto* const found =
      std::find_if(std::begin(names), std::end(names), [&](const Names& one) { return one.glsl == glsl; });
  return found == std::end(names) ? std::string_view{} : found->hlsl;
}

}  // namespace penumbra::shaders
