// Unity's types of textures and samplers with a precision, such as Texture2D_half, which its libraries name
// for mobile platforms. FXC knows none of them: for it they are the types without.
#pragma once

#include <d3dcompiler.h>

#define PENUMBRA_TYPE_OF_UNITY(type) \
  {type "_half", type}, {            \
    type "_float", type              \
  }

static const D3D_SHADER_MACRO types_of_unity[] = {PENUMBRA_TYPE_OF_UNITY("Texture2D"),
                                                  PENUMBRA_TYPE_OF_UNITY("Texture2DArray"),
                                                  PENUMBRA_TYPE_OF_UNITY("Texture2DMS"),
                                                  PENUMBRA_TYPE_OF_UNITY("Texture3D"),
                                                  PENUMBRA_TYPE_OF_UNITY("TextureCube"),
                                                  PENUMBRA_TYPE_OF_UNITY("TextureCubeArray"),
                                                  PENUMBRA_TYPE_OF_UNITY("sampler"),
                                                  PENUMBRA_TYPE_OF_UNITY("sampler1D"),
                                                  PENUMBRA_TYPE_OF_UNITY("sampler2D"),
                                                  PENUMBRA_TYPE_OF_UNITY("sampler3D"),
                                                  PENUMBRA_TYPE_OF_UNITY("samplerCUBE"),
                                                  PENUMBRA_TYPE_OF_UNITY("SamplerState"),
                                                  {NULL, NULL}};
