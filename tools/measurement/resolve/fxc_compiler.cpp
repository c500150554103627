#include "resolve/fxc_compiler.h"

#include <memory>

#include "fxc/messages.h"
#include "hlsl/diagnostic.h"
#include "input/input_error.h"
#include "platform/worker_pool.h"
#include "shaders/fxc_program.h"

namespace penumbra::resolve {
namespace {

std::string errors_in(const fxc::Verdict& verdict, const shaders::CompileRequest& request,
                      const std::string& expanded) {
  std::string errors;
  for (const hlsl::Diagnostic& said :
       fxc::diagnostics_of(verdict.messages, expanded, request.file.string(), hlsl::SourceFiles()))
    if (said.severity == hlsl::Severity::error) errors += (errors.empty() ? "" : "\n") + hlsl::format(said);
  return errors;
}

}  // namespace

BytecodeCompiler bytecode_by_fxc(const fxc::Installation& installation, const fxc::JudgeLimits& limits) {
  const auto judge = std::make_shared<std::unique_ptr<fxc::Judge>>();
  return [installation, limits, judge](const shaders::CompileRequest& request, const std::string& expanded) {
    if (*judge == nullptr) *judge = std::make_unique<fxc::Judge>(installation, limits);
    try {
      fxc::Verdict verdict = (*judge)->compile(shaders::fxc_program(request, expanded));
      if (verdict.compiled) return Bytecode{std::move(verdict.bytecode), {}};
      return Bytecode{{}, errors_in(verdict, request, expanded)};
    } catch (const platform::WorkerSpent& spent) {
      judge->reset();
      throw InputError(request.file.string(), spent.what());
    }
  };
}

}  // namespace penumbra::resolve
