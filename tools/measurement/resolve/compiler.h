// The compilers of a graph's programs: glslang and vkd3d in another process, and FXC.
#pragma once

#include <functional>
#include <string>

#include "fxc/judge.h"
#include "platform/worker_pool.h"
#include "shaders/compile.h"

namespace penumbra::resolve {

// FXC's result for a text without includes and macros.
struct Bytecode {
  std::string bytes;     // a DXBC container; empty if FXC refuses the text
  std::string messages;  // FXC's messages, which say why
};
using BytecodeCompiler =
    std::function<Bytecode(const shaders::CompileRequest& request, const std::string& expanded)>;

struct Compiler {
  Compiler() = default;
  Compiler(platform::WorkerPool worker, BytecodeCompiler compiler = {})
      : process(std::move(worker)), fxc(std::move(compiler)) {}

  // The pool starts this program as serve_modules(): glslang and vkd3d run there, as they may crash. Without
  // arguments they run in this process.
  platform::WorkerPool process;
  // If it is set, programs are run from FXC's bytecode, by vkd3d (shaders/bytecode_module.h), in place of
  // glslang's modules. It is called in this process.
  BytecodeCompiler fxc;
};

// One FXC compiles all programs, in its own confined process; it starts with the first. It throws InputError
// for a program with which FXC crashes or exceeds a limit. Not thread-safe.
BytecodeCompiler bytecode_by_fxc(const fxc::Installation& installation, const fxc::JudgeLimits& limits = {});

}  // namespace penumbra::resolve
