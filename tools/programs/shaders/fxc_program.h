// A program as Unity gives it to FXC.
#pragma once

#include <string>

#include "fxc/judge.h"
#include "shaders/compile.h"

namespace penumbra::shaders {

// By the request's SHADER_TARGET; of one without, which may use all of shader model 5, 5.0.
std::string fxc_profile(const CompileRequest& request);

// expanded: the request's text without includes and macros, of expand() or of preprocess() without
// preparation.
fxc::Program fxc_program(const CompileRequest& request, const std::string& expanded);

}  // namespace penumbra::shaders
