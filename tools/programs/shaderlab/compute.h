// The kernels of a .compute file: https://docs.unity3d.com/Manual/class-ComputeShader.html.
//
// "#pragma kernel NAME" declares the function NAME as a kernel; the rest of the line lists macros to define
// while that kernel is compiled, "MACRO" or "MACRO=VALUE". Only the file's own text is read: not its
// includes, and #if is not evaluated.
#pragma once

#include "hlsl/diagnostic.h"
#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

struct KernelDefine {
  Name macro;
  std::string value;  // empty for a macro without a value
};

struct Kernel {
  Name function;
  Place place;  // place of the '#'
  std::vector<KernelDefine> defines;
};

struct ComputeKernels {
  std::string text;  // normalised; the locations refer to it
  std::vector<Kernel> kernels;
  std::vector<hlsl::Diagnostic> diagnostics;  // a malformed line is an error and declares no kernel
};

// A .raytrace file is refused with one error.
ComputeKernels compute_kernels(std::string_view bytes, const std::string& file);

}  // namespace penumbra::shaderlab
