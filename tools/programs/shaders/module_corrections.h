#pragma once

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Integer inputs of a fragment shader are not interpolated, whether the source says so or not
// (docs.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-struct), and SPIR-V for Vulkan requires the
// decoration Flat (VUID-StandaloneSpirv-Flat-04744). glslang omits it for members of nested structs.
//
// Decorates the integer inputs of fragment entry points that lack it.
void flatten_integer_inputs(SpirvModule& module);

// Texture2D.GatherCmp: glslang mistakes an operand for a bias and adds Bias to OpImageDrefGather, which
// SPIR-V allows only with implicit levels (specification, 3.14). A gather reads the first level.
//
// Removes the operand from OpImageDrefGather, and the capability that it requires from the module.
void drop_gather_bias(SpirvModule& module);

// A gather with four constant offsets, which Direct3D, Vulkan and desktop OpenGL have: SPIRV-Cross emits one
// of the offsets for Metal and none for HLSL, and OpenGL ES has no such function. Each offset's texel is the
// last of a gather with that offset alone
// (learn.microsoft.com/windows/win32/direct3dhlsl/texture2d-gatherred).
//
// Replaces OpImageGather and OpImageDrefGather with ConstOffsets by four of ConstOffset.
void split_gathers(SpirvModule& module);

// The result of % and fmod has the sign of the dividend in HLSL: (-7) % 2 is -1. glslang emits the
// instructions of GLSL's mod(), whose result has the sign of the divisor.
//
// OpFMod becomes OpFRem. OpSMod a, b becomes a - b * (a / b): Vulkan leaves OpSRem and OpSMod of negative
// numbers undefined, and OpSDiv truncates.
void truncate_remainders(SpirvModule& module);

// The functions any(x) and all(x) of a scalar, which HLSL has
// (docs.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-any). glslang emits OpAny and OpAll for
// them, which only accept vectors (SPIR-V specification 3.42.15); for a single bool the result is that bool.
//
// Replaces OpAny and OpAll of one bool by OpCopyObject.
void copy_scalar_conditions(SpirvModule& module);

// Static variables without an initialiser are zero in HLSL
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-variable-syntax). glslang leaves them
// undefined.
//
// Private variables get a null constant as their initialiser if their type has one: all except those that
// contain textures, samplers or buffers.
void zero_statics(SpirvModule& module);

// Matrices of integers and bools, which HLSL has and SPIR-V does not (SPIR-V specification, OpTypeMatrix: the
// components are floats).
//
// OpTypeMatrix of ints and bools becomes an array of vectors, which every instruction that glslang emits for
// them also accepts: loads and stores, construction, extraction, access chains. A matrix that is a member of
// a buffer is not changed, because its layout differs from that of an array; validation then rejects the
// module.
void make_whole_matrices_arrays(SpirvModule& module);

}  // namespace penumbra::shaders
