// An independent opinion on emitted GLSL and ESSL: the GL driver of this machine compiles and links it.
//
// Headless, through EGL's surfaceless platform (Mesa's llvmpipe where there is no GPU). Every thread has
// contexts of its own. GLSL goes to a desktop OpenGL 4.5 core context, ESSL to an OpenGL ES 3.1 context, so
// that either is held to its own rules.
#pragma once

#include <string>
#include <vector>

#include "hlsl/diagnostic.h"
#include "shaders/compile.h"
#include "shaders/cross_compile.h"

namespace penumbra::shaders {

struct GlStage {
  hlsl::Stage stage = hlsl::Stage::compute;
  std::string text;
};

// The driver's errors and warnings, their place in the emitted text; file is the target's name. Several
// stages are linked with each other, a single one as a separable program. Target: essl310 or glsl450.
// Throws EnvironmentError when there is no EGL or no such context.
std::vector<hlsl::Diagnostic> gl_check(const std::vector<GlStage>& stages, Target target);

// GL_VERSION of the context that checks the target, for reports.
std::string gl_driver(Target target);

}  // namespace penumbra::shaders
