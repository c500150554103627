// FXC as a graph's compiler.
#pragma once

#include "fxc/judge.h"
#include "resolve/compiler.h"

namespace penumbra::resolve {

// One FXC compiles all programs, in its own confined process; it starts with the first. It throws InputError
// for a program with which FXC crashes or exceeds a limit. Not thread-safe.
BytecodeCompiler bytecode_by_fxc(const fxc::Installation& installation, const fxc::JudgeLimits& limits = {});

}  // namespace penumbra::resolve
