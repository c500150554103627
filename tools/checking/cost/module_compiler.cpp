#include "cost/module_compiler.h"

#include <stdexcept>

#include "cost/compiler_worker.h"
#include "platform/byte_stream.h"
#include "platform/worker_answer.h"
#include "shaders/compile_message.h"
#include "shaders/compiler_failure.h"

namespace penumbra::cost {
namespace {

std::string compile_message(const std::string& message, platform::WorkerLink&) {
  return platform::answer_or_input_error([&] {
    platform::ByteReader in(message);
    shaders::CompileResult result = shaders::compile(shaders::read_compile_request(in));
    CompiledModule module{std::move(result.spirv), {}, std::move(result.diagnostics)};
    if (!module.spirv.empty()) module.counts = count_spirv(module.spirv);
    return encode(module);
  });
}

class Requests final : public platform::WorkSource {
 public:
  explicit Requests(const std::vector<shaders::CompileRequest>& requests)
      : modules(requests.size()), requests_(requests) {}

  std::optional<platform::WorkerMessage> next(unsigned) override {
    if (next_ == requests_.size()) return std::nullopt;
    platform::ByteWriter out;
    shaders::write(out, requests_[next_]);
    return platform::WorkerMessage{next_++, out.take()};
  }
  std::string answer_question(std::size_t, const std::string&) override { return {}; }
  void finished(std::size_t number, platform::WorkerOutcome outcome) override {
    if (outcome.failure.empty()) {
      modules[number] = decode_module(platform::taken_answer(std::move(outcome.answer)));
      return;
    }
    const shaders::CompilerFailure failure = shaders::compiler_failure(outcome);
    modules[number].diagnostics.push_back({requests_[number].file.string(),
                                           0,
                                           0,
                                           hlsl::Severity::error,
                                           failure.problem + "; " + failure.way_out,
                                           {}});
  }

  std::vector<CompiledModule> modules;

 private:
  const std::vector<shaders::CompileRequest>& requests_;
  std::size_t next_ = 0;
};

}  // namespace

std::string encode(const CompiledModule& module) {
  platform::ByteWriter out;
  out.values(module.spirv);
  out.value(module.counts);
  shaders::write(out, module.diagnostics);
  return out.take();
}

CompiledModule decode_module(const std::string& bytes) {
  platform::ByteReader in(bytes);
  CompiledModule module;
  module.spirv = in.values<std::uint32_t>();
  module.counts = in.value<SpirvCounts>();
  module.diagnostics = shaders::read_diagnostics(in);
  if (!in.exhausted()) throw std::invalid_argument("malformed compiled module");
  return module;
}

std::vector<CompiledModule> compile_all(const std::vector<shaders::CompileRequest>& requests,
                                        const platform::WorkerPool& pool) {
  Requests source(requests);
  if (pool.arguments.empty())
    platform::run_in_threads(pool.workers, compile_message, source);
  else
    platform::run_workers(pool, source);
  return std::move(source.modules);
}

int serve_compiler() {
  return platform::serve_worker(compile_message);
}

}  // namespace penumbra::cost
