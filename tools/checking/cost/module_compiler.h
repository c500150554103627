// Compiles sources in worker processes, and counts the instructions of bytecode there. Internal to this
// folder, except for the worker's side.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fxc/bytecode.h"
#include "hlsl/diagnostic.h"
#include "platform/worker_pool.h"
#include "shaders/compile.h"

namespace penumbra::cost {

enum class Compiler : std::uint64_t { glslang, fxc };

struct CompiledModule {
  std::vector<std::uint32_t> spirv;  // empty when a diagnostic is an error, or for FXC
  std::string bytecode;              // FXC's; empty when a diagnostic is an error, or for glslang
  fxc::BytecodeCost direct3d{};      // cost of the bytecode
  std::vector<hlsl::Diagnostic> diagnostics;

  bool is_compiled() const { return !spirv.empty() || !bytecode.empty(); }
};

// Returns one module per request, in order. A request that crashes its worker gets a diagnostic. Without
// arguments in `pool`, threads do the work. Throws InputError for a file that cannot be read,
// EnvironmentError, platform::Interrupted.
std::vector<CompiledModule> compile_all(const std::vector<shaders::CompileRequest>& requests,
                                        Compiler compiler, const platform::WorkerPool& pool);

std::string encode(const CompiledModule& module);
CompiledModule decode_module(const std::string& bytes);  // throws std::invalid_argument for damaged bytes

// The process in which `penumbra cost` compiles: the program, started with this argument.
inline constexpr const char* compiler_worker_mode = "cost-compiler";

// `arguments` are those behind the mode; returns the exit code of the process.
int serve_compiler(const std::vector<std::string>& arguments);

}  // namespace penumbra::cost
