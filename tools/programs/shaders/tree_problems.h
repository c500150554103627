#pragma once

#include <glslang/Include/intermediate.h>

#include "shaders/spirv_module.h"
#include "shaders/tree_rewrite.h"

namespace penumbra::shaders {

// Reads without comparison through a comparison sampler. HLSL has no such overload; glslang accepts them and
// treats the next argument as the comparison reference, or crashes if there is none.
//
// Finds them in the whole syntax tree, because SPIR-V is generated for all of it.
std::vector<hlsl::Diagnostic> reads_without_comparing(const glslang::TIntermediate& tree);

// Arguments of out and inout parameters that have another type than the parameter: HLSL converts them in both
// directions, glslang on input only, so that the result would be lost.
std::vector<hlsl::Diagnostic> converted_arguments(const glslang::TIntermediate& tree);

// Operations that HLSL applies to every element of a matrix, and glslang does not: it multiplies m * n as
// mul() does, its SPIR-V back end has no functions or comparisons of matrices and no matrices of whole
// numbers or bools, and emits wrong instructions for them or crashes. FXC decides on such a text.
//
// `text` is what glslang has parsed; lines before its first #line are in `main_file`.
std::vector<hlsl::Diagnostic> operations_on_matrices(const glslang::TIntermediate& tree,
                                                     const std::string& text, const std::string& main_file);

// Calls of intrinsic functions for which glslang's SPIR-V back end emits instructions with another meaning
// than in HLSL. They are corrected in the syntax tree, where the types of the arguments are known.
//
// - abs(u) of an unsigned integer is u; the back end treats it as signed.
// - mad(a, b, c) is a * b + c, also for integers, for which there is no Fma. HLSL does not specify whether it
//   rounds once or twice.
// - -u of an unsigned integer is 0 - u: SPIRV-Tools 2023.1 folds -(u / 2) to u / -2.
// - ldexp(x, e) with a float e is x * exp2(e); Ldexp takes integer exponents.
void correct_operations(glslang::TIntermediate& tree);

// Structured buffers, whose elements Direct3D packs like C's structs of 32-bit words
// (learn.microsoft.com/windows/win32/direct3dhlsl/sm5-object-structuredbuffer); glslang gives them the
// offsets of GL's std430, in which `float a; float3 b;` leaves 12 bytes between the two.
void lay_out_buffers(glslang::TIntermediate& tree);

// Constant buffers: Direct3D packs a member into the last register of the matrix, array or struct before it
// where it fits (`float3x3 m; float g;` has g at word 11), and glslang begins a new register. Such a member
// gets the offset of Direct3D; inside of a struct it is an error. Variables at file scope keep the offsets of
// glslang: Unity sets them by their names.
std::vector<hlsl::Diagnostic> lay_out_cbuffers(glslang::TIntermediate& tree);

}  // namespace penumbra::shaders
