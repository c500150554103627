#pragma once

#include <glslang/Include/intermediate.h>

#include "shaders/cross_compile.h"
#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Direct3D 11's limits of a compute program's group: threads and shared memory (FXC X3655, X4586).
//
// https://learn.microsoft.com/windows/win32/direct3dhlsl/sm5-attributes-numthreads
//
// Finds [numthreads] beyond 1024, 1024 and 64 threads along the axes or 1024 in total, and more than 32 KiB
// of groupshared variables that `optimised` still uses. `text` and `file` are the source, for the locations.
std::vector<hlsl::Diagnostic> beyond_group_limits(const glslang::TIntermediate& tree,
                                                  const SpirvModule& optimised, const std::string& text,
                                                  const std::string& file);

// Integer matrices in memory, such as a cbuffer's int4x4: SPIR-V, GLSL and Metal have only float matrices
// (SPIR-V specification, OpTypeMatrix).
//
// Finds those that remain in `optimised`; `text` and `file` are its source, for the locations.
std::vector<hlsl::Diagnostic> integer_matrices(const SpirvModule& optimised, const std::string& text,
                                               const std::string& file);

// Two resources at one explicit register: FXC X4500, X4578.
//
// HLSL's compilers report it if the program uses both.
//
// `optimised` is the module with the names of the resources that it still uses; `text` and `file` are its
// source.
std::vector<hlsl::Diagnostic> shared_registers(const SpirvModule& optimised, const std::string& text,
                                               const std::string& file);

// Constructs of HLSL that some targets cannot express, with their lines: SPIRV-Cross and OpenGL drivers name
// no line of the source.
struct TargetProblem {
  std::vector<Target> targets;
  hlsl::Diagnostic problem;
};

// Finds wave functions, evaluation of an attribute elsewhere in its pixel, fine and coarse derivatives, and
// arrays of constant buffers. It is for optimised modules; lines are known only in those with debug lines.
// `text` is the source, in which the declarations of buffers are found; `file` is its name.
std::vector<TargetProblem> target_problems(const SpirvModule& module, const std::string& text,
                                           const std::string& file);

}  // namespace penumbra::shaders
