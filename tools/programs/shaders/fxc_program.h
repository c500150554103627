// A program as Unity gives it to FXC.
#pragma once

#include "fxc/judge.h"
#include "shaders/compile.h"

namespace penumbra::shaders {

// The profile follows the request's SHADER_TARGET; a request without one, which may use all of shader model
// 5, gets 5.0.
std::string fxc_profile(const CompileRequest& request);

// `expanded` is the request's text without includes and macros, from expand() or from preprocess() without
// preparation.
fxc::Program fxc_program(const CompileRequest& request, const std::string& expanded);

}  // namespace penumbra::shaders
