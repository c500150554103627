// What one target says to a module: emitted by SPIRV-Cross and, where that is wanted, compiled and linked by
// this machine's driver for it. Internal to this room.
#pragma once

#include <string>
#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/stage.h"
#include "shaders/cross_compile.h"

namespace penumbra::validation {

// Why no shader of this stage is made for the target; empty where one is.
std::string why_absent(hlsl::Stage stage, const std::string& target);

// Nothing for "spirv": a module that is there has passed; nothing for a stage that is absent. Throws
// EnvironmentError when GL is needed and not there.
std::vector<hlsl::Diagnostic> check_target(shaders::CrossCompiler& module, hlsl::Stage stage,
                                           const std::string& target, bool with_driver);

// The driver that checks the target; empty where none does. Throws EnvironmentError as above.
std::string checking_driver(const std::string& target);

// Of these targets, on this thread, so that checking them later opens no file. The driver keeps nothing on
// disk.
void open_drivers(const std::vector<std::string>& targets);

// Who checks the target, for reports: "compiled and linked by OpenGL driver ..." and the like.
std::string checked_by(const std::string& target);

}  // namespace penumbra::validation
