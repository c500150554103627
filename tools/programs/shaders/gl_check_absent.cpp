// Replaces gl_check.cpp on platforms without EGL.
#include "input/input_error.h"
#include "shaders/gl_check.h"

namespace penumbra::shaders {

std::vector<hlsl::Diagnostic> gl_check(const std::vector<GlStage>& /*stages*/, Target target) {
  throw EnvironmentError(std::string("this build has no EGL, which checking ") + target_name(target) +
                         " needs");
}

std::string gl_driver(Target /*target*/) {
  throw EnvironmentError("this build has no EGL");
}

}  // namespace penumbra::shaders
