#include "resolve/compiler.h"

#include <map>
#include <memory>

#include "fxc/messages.h"
#include "hlsl/diagnostic.h"
#include "input/input_error.h"
#include "platform/content_hash.h"
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
  struct Known {
    std::unique_ptr<fxc::Judge> judge;
    std::map<std::string, Bytecode> answers;  // answers by program: graphs share the programs of their passes
  };
  const auto known = std::make_shared<Known>();
  return [installation, limits, known](const shaders::CompileRequest& request, const std::string& expanded) {
    const fxc::Program program = shaders::fxc_program(request, expanded);
    const std::string key =
        platform::ContentHash().update(program.text).update(program.entry).update(program.profile).hex();
    if (const auto answer = known->answers.find(key); answer != known->answers.end()) return answer->second;
    if (known->judge == nullptr) known->judge = std::make_unique<fxc::Judge>(installation, limits);
    try {
      fxc::Verdict verdict = known->judge->compile(program);
      if (!verdict.compiled) return Bytecode{{}, errors_in(verdict, request, expanded)};
      return known->answers[key] = {std::move(verdict.bytecode), {}};
    } catch (const platform::WorkerSpent& spent) {
      known->judge.reset();
      throw InputError(request.file.string(), spent.what());
    }
  };
}

}  // namespace penumbra::resolve
