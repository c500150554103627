// `#pragma pack_matrix(row_major)`
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-appendix-pre-pragma- pack-matrix), which
// says how the matrices that follow lie in buffers. Each declaration of a matrix at file scope, in a cbuffer
// or in a struct that has no row_major or column_major of its own gets the row_major that the pragma gives
// it; StructuredBuffer<float4x4> takes none in glslang and is an error.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void pack_matrices(TokenText& text);

}  // namespace penumbra::preparation
