// Modules for the tests that run them on the device.
#pragma once

#include <stdexcept>
#include <string>

#include "fxc/judge.h"
#include "shaders/bytecode_module.h"
#include "shaders/compile.h"
#include "shaders/fxc_program.h"
#include "shaders/source_memory.h"

namespace penumbra::shaders {

// Throws std::runtime_error with the messages.
inline SpirvModule module_by_glslang(const CompileRequest& request) {
  CompileResult result = compile(request);
  if (!hlsl::has_errors(result.diagnostics)) return std::move(result.spirv);
  std::string messages;
  for (const hlsl::Diagnostic& diagnostic : result.diagnostics) messages += format(diagnostic) + "\n";
  throw std::runtime_error(messages);
}

// The module that `penumbra validate` makes of FXC's bytecode where glslang refuses a text. Throws
// std::runtime_error with FXC's messages; EnvironmentError where there is no FXC.
inline SpirvModule module_by_fxc(const CompileRequest& request) {
  static fxc::Judge judge(fxc::require_fxc());
  SourceMemory memory;
  const fxc::Verdict verdict = judge.compile(fxc_program(request, expand(request, memory).text));
  if (!verdict.compiled) throw std::runtime_error(verdict.messages);
  return bytecode_module(verdict.bytecode, request.entry).spirv;
}

}  // namespace penumbra::shaders
