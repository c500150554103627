// `#pragma pack_matrix(row_major)`
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-appendix-pre-pragma-pack-matrix), which
// sets the layout of the following matrices in buffers. Each declaration of a matrix at file scope, in a
// cbuffer or in a struct without a row_major or column_major of its own gets row_major;
// StructuredBuffer<float4x4>, for which glslang accepts none, is an error.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void pack_matrices(TokenText& text);

}  // namespace penumbra::preparation
