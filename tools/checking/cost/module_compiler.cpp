#include "cost/module_compiler.h"

#include <map>
#include <memory>
#include <stdexcept>

#include "fxc/judge.h"
#include "fxc/messages.h"
#include "platform/byte_stream.h"
#include "platform/worker_answer.h"
#include "shaders/compile_message.h"
#include "shaders/fxc_program.h"
#include "shaders/source_memory.h"

namespace penumbra::cost {
namespace {

constexpr const char* fxc_argument = "fxc";  // follows the worker's mode: the worker compiles by FXC, too

CompiledModule compiled_by_glslang(const shaders::CompileRequest& request) {
  CompiledModule module;
  shaders::CompileResult result = shaders::compile(request);
  module.spirv = std::move(result.spirv);
  module.diagnostics = std::move(result.diagnostics);
  return module;
}

// Each thread has one. In a process it starts before that is confined.
thread_local std::unique_ptr<fxc::Judge> judge;

fxc::Verdict verdict_on(const fxc::Program& program) {
  if (judge == nullptr) judge = std::make_unique<fxc::Judge>(fxc::require_fxc());
  try {
    return judge->compile(program);
  } catch (const platform::WorkerSpent&) {
    judge.reset();
    throw;
  }
}

CompiledModule compiled_by_fxc(const shaders::CompileRequest& request) {
  shaders::SourceMemory memory;
  shaders::PreprocessedSource source = shaders::expand(request, memory);
  CompiledModule module;
  module.diagnostics = std::move(source.diagnostics);
  if (hlsl::has_errors(module.diagnostics)) return module;
  fxc::Verdict verdict = verdict_on(shaders::fxc_program(request, source.text));
  for (hlsl::Diagnostic& said :
       fxc::diagnostics_of(verdict.messages, source.text, request.file.string(), source.sources))
    module.diagnostics.push_back(std::move(said));
  const std::optional<fxc::BytecodeCost> cost = fxc::bytecode_cost(verdict.bytecode);
  if (cost) {
    module.direct3d = *cost;
    module.bytecode = std::move(verdict.bytecode);
  } else if (!hlsl::has_errors(module.diagnostics)) {
    module.diagnostics.push_back({request.file.string(),
                                  0,
                                  0,
                                  hlsl::Severity::error,
                                  "FXC gives no bytecode for it, and no message",
                                  {}});
  }
  return module;
}

std::string compile_message(const std::string& message, platform::WorkerLink&) {
  return platform::answer_or_input_error([&] {
    platform::ByteReader in(message);
    const auto compiler = in.enumerator(Compiler::fxc);
    const shaders::CompileRequest request = shaders::read_compile_request(in);
    return encode(compiler == Compiler::fxc ? compiled_by_fxc(request) : compiled_by_glslang(request));
  });
}

class Requests final : public platform::WorkSource {
 public:
  // Each request is made once, because techniques share the programs of their passes.
  Requests(const std::vector<shaders::CompileRequest>& requests, Compiler compiler) : requests_(requests) {
    std::map<std::string, std::size_t> known;
    for (std::size_t i = 0; i < requests.size(); ++i) {
      platform::ByteWriter out;
      out.number(static_cast<std::uint64_t>(compiler));
      shaders::write(out, requests[i]);
      const auto [place, is_new] = known.try_emplace(out.take(), order_.size());
      if (is_new) order_.push_back({&place->first, i});
      order_of_.push_back(place->second);
    }
    messages_ = std::move(known);
    modules_.resize(order_.size());
  }

  std::optional<platform::WorkerMessage> next(unsigned) override {
    if (next_ == order_.size()) return std::nullopt;
    const std::size_t number = next_++;
    return platform::WorkerMessage{number, *order_[number].message};
  }
  std::string answer_question(std::size_t, const std::string&) override { return {}; }
  void finished(std::size_t number, platform::WorkerOutcome outcome) override {
    if (outcome.failure.empty()) {
      modules_[number] = decode_module(platform::taken_answer(std::move(outcome.answer)));
      return;
    }
    const shaders::CompilerFailure failure = shaders::compiler_failure(outcome);
    modules_[number].diagnostics.push_back({requests_[order_[number].request].file.string(),
                                            0,
                                            0,
                                            hlsl::Severity::error,
                                            failure.problem + "; " + failure.remedy,
                                            {}});
  }

  // Returns the modules of all requests.
  std::vector<CompiledModule> modules() const {
    std::vector<CompiledModule> all;
    for (const std::size_t number : order_of_) all.push_back(modules_[number]);
    return all;
  }

 private:
  struct Order {
    const std::string* message = nullptr;
    std::size_t request = 0;  // the first of equal requests
  };

  const std::vector<shaders::CompileRequest>& requests_;
  std::map<std::string, std::size_t> messages_;
  std::vector<Order> order_;
  std::vector<std::size_t> order_of_;  // the place of each request
  std::vector<CompiledModule> modules_;
  std::size_t next_ = 0;
};

}  // namespace

std::string encode(const CompiledModule& module) {
  platform::ByteWriter out;
  out.values(module.spirv);
  out.text(module.bytecode);
  out.value(module.direct3d);
  shaders::write(out, module.diagnostics);
  return out.take();
}

CompiledModule decode_module(const std::string& bytes) {
  platform::ByteReader in(bytes);
  CompiledModule module;
  module.spirv = in.values<std::uint32_t>();
  module.bytecode = in.text();
  module.direct3d = in.value<fxc::BytecodeCost>();
  module.diagnostics = shaders::read_diagnostics(in);
  if (!in.exhausted()) throw std::invalid_argument("malformed compiled module");
  return module;
}

std::vector<CompiledModule> compile_all(const std::vector<shaders::CompileRequest>& requests,
                                        Compiler compiler, const platform::WorkerPool& pool) {
  Requests source(requests, compiler);
  if (pool.arguments.empty()) {
    platform::run_in_threads(pool.workers, compile_message, source);
  } else {
    platform::WorkerPool with_compiler = pool;
    if (compiler == Compiler::fxc) with_compiler.arguments.emplace_back(fxc_argument);
    platform::run_workers(with_compiler, source);
  }
  return source.modules();
}

int serve_compiler(const std::vector<std::string>& arguments) {
  if (arguments != std::vector<std::string>{fxc_argument}) return platform::serve_worker(compile_message);
  return platform::serve_worker(compile_message, [](const platform::WorkerLimits& limits) {
    judge = std::make_unique<fxc::Judge>(fxc::require_fxc(), fxc::limits_of(limits));
  });
}

}  // namespace penumbra::cost
