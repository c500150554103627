// What compiles the programs of a graph.
#pragma once

#include <functional>
#include <string>

#include "platform/worker_pool.h"
#include "shaders/compile.h"

namespace penumbra::resolve {

// FXC's answer for a text without includes and macros.
struct Bytecode {
  std::string bytes;     // a DXBC container; empty: refused
  std::string messages;  // why
};
using BytecodeCompiler =
    std::function<Bytecode(const shaders::CompileRequest& request, const std::string& expanded)>;

struct Compiler {
  Compiler() = default;
  Compiler(platform::WorkerPool worker, BytecodeCompiler compiler = {})
      : process(std::move(worker)), fxc(std::move(compiler)) {}

  // Starts this program as serve_modules(): glslang and vkd3d run there, as they may crash. Without arguments
  // they run in this process.
  platform::WorkerPool process;
  // Set: programs are run from FXC's bytecode, by vkd3d (shaders/bytecode_module.h), in place of glslang's
  // modules. Called in this process.
  BytecodeCompiler fxc;
};

}  // namespace penumbra::resolve
