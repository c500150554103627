#pragma once

#include "shaders/cross_compile.h"
#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Constructs of HLSL that some targets cannot express, with their lines: SPIRV-Cross and OpenGL drivers name
// no line of the source.
struct TargetProblem {
  std::vector<Target> targets;
  hlsl::Diagnostic problem;
};

// Finds wave functions, evaluation of an attribute elsewhere in its pixel, fine and coarse derivatives,
// gathers at variable offsets, sizes of buffers, and arrays of constant buffers. It is for optimised modules;
// lines are known only in those with debug lines. `text` is the source, in which the declarations of buffers
// are found; `file` is its name.
std::vector<TargetProblem> target_problems(const SpirvModule& module, const std::string& text,
                                           const std::string& file);

}  // namespace penumbra::shaders
