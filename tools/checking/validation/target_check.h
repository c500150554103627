// A check of a module for one target: SPIRV-Cross emits its text and, if requested, this machine's driver
// compiles and links it. Internal to this folder.
#pragma once

#include <string>
#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/stage.h"
#include "shaders/cross_compile.h"

namespace penumbra::validation {

// Says why the target has no shaders of this stage; empty if it has.
std::string why_absent(hlsl::Stage stage, const std::string& target);

// Returns the emitted text and what is said of it. Does nothing for "spirv", because an existing module has
// passed, and for a stage that is absent. Throws EnvironmentError if GL is needed and missing.
shaders::CrossCompileResult check_target(shaders::CrossCompiler& module, hlsl::Stage stage,
                                         const std::string& target, bool with_driver);

// Returns the driver, or FXC, that checks the target; empty where none does. Throws EnvironmentError as
// above, and where FXC is wanted and missing.
std::string checking_driver(const std::string& target);

// Opens the drivers of these targets on this thread, so that checking them later opens no file. The driver's
// disk cache is disabled.
void open_drivers(const std::vector<std::string>& targets);

// Describes for reports how the target is checked: "compiled and linked by OpenGL driver ..." and similar.
std::string checked_by(const std::string& target);

}  // namespace penumbra::validation
