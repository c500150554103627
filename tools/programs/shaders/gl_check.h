// An independent check of emitted GLSL and ESSL: this machine's GL driver compiles and links it.
//
// It is headless, through EGL's surfaceless platform (Mesa's llvmpipe if there is no GPU). Every thread has
// its own contexts. GLSL is checked in a desktop OpenGL 4.5 core context, ESSL in an OpenGL ES 3.1 context,
// each by its own rules.
#pragma once

#include "hlsl/diagnostic.h"
#include "shaders/compile.h"
#include "shaders/cross_compile.h"

namespace penumbra::shaders {

struct GlStage {
  hlsl::Stage stage = hlsl::Stage::compute;
  std::string text;
};

// Returns the driver's errors and warnings, with locations in the emitted text; `file` is the target's name.
// Several stages are linked with each other, a single one as a separable program. The target is essl310 or
// glsl450. Throws EnvironmentError if there is no EGL or no such context.
std::vector<hlsl::Diagnostic> gl_check(const std::vector<GlStage>& stages, Target target);

// Returns GL_VERSION of the context that checks the target, for reports.
std::string gl_driver(Target target);

}  // namespace penumbra::shaders
