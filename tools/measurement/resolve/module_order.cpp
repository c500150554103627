#include "resolve/module_order.h"

#include <stdexcept>

#include "input/input_error.h"
#include "platform/byte_stream.h"
#include "platform/worker_answer.h"
#include "resolve/adapter_checks.h"
#include "resolve/named_places.h"
#include "resolve/required_module.h"
#include "shaders/bytecode_module.h"
#include "shaders/compile_message.h"
#include "shaders/compiler_failure.h"
#include "shaders/counted_module.h"
#include "shaders/spirv_module.h"
#include "shaders/translation_steps.h"

namespace penumbra::resolve {

using platform::ByteReader;
using platform::ByteWriter;

namespace {

const MissingName kAdapterFunction{
    "ShadowVisibility",
    "an adapter defines: float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)"};

CompiledModules compile_here(const ModuleOrder& order) {
  CompiledModules made;
  if (order.vertex) {
    VertexModule vertex = required_vertex_module(*order.vertex);
    made.vertex = std::move(vertex.spirv);
    made.vertex_inputs = std::move(vertex.inputs);
  }
  shaders::CompileRequest plain = order.plain;
  plain.keep_unoptimised = true;
  hlsl::SourceFiles sources;
  std::vector<std::uint32_t> unoptimised;
  made.plain = required_module(plain, &made.notes, &kAdapterFunction, &sources, &unoptimised);
  if (order.names_places) made.named_at = named_places(made.plain, sources, kAdapterFunction.name);
  if (order.is_adapter) check_adapter(unoptimised, order.name, made.named_at);
  made.counting = shaders::counted_module(unoptimised, plain.entry, plain.vulkan);
  return made;
}

// The tasks of a process.
enum class Task : std::uint64_t { compile, expand, translate };

// The texts of an order's programs, as FXC takes them, and its bytecode for them.
struct StageTexts {
  std::string vertex;  // empty without a request
  std::string plain;
};

StageTexts expand_here(const ModuleOrder& order) {
  return {order.vertex ? required_text(*order.vertex) : "", required_text(order.plain)};
}

shaders::BytecodeModule translated(const std::string& bytecode, const shaders::CompileRequest& request) {
  try {
    return shaders::bytecode_module(bytecode, request.entry);
  } catch (const std::invalid_argument& problem) {
    throw InputError(request.file.string(), problem.what());
  }
}

CompiledModules translate_here(const ModuleOrder& order, const StageTexts& bytecode) {
  CompiledModules made;
  if (order.vertex) {
    shaders::BytecodeModule module = translated(bytecode.vertex, *order.vertex);
    VertexModule vertex = vertex_module(std::move(module.spirv), module.signature, order.vertex->entry);
    made.vertex = std::move(vertex.spirv);
    made.vertex_inputs = std::move(vertex.inputs);
  }
  shaders::BytecodeModule module = translated(bytecode.plain, order.plain);
  made.plain = std::move(module.spirv);
  hlsl::SourceFiles sources;
  if (order.names_places) {
    required_text(order.plain, &sources);
    made.named_at = named_places(made.plain, sources, kAdapterFunction.name);
  }
  if (order.is_adapter) check_adapter(module.untouched, order.name, made.named_at);
  made.counting = shaders::counted_module(module.untouched, order.plain.entry, order.plain.vulkan,
                                          shaders::translation_steps(module.untouched));
  return made;
}

std::string encode(const ModuleOrder& order, Task task, const StageTexts& bytecode = {}) {
  const auto& [name, file, vertex, plain, names_places, is_adapter] = order;
  ByteWriter out;
  out.number(static_cast<std::uint64_t>(task));
  out.text(bytecode.vertex);
  out.text(bytecode.plain);
  out.text(name);
  out.text(file);
  out.number(vertex ? 1 : 0);
  if (vertex) shaders::write(out, *vertex);
  shaders::write(out, plain);
  out.number(names_places ? 1 : 0);
  out.number(is_adapter ? 1 : 0);
  return out.take();
}

ModuleOrder decode_order(ByteReader& in) {
  ModuleOrder order;
  order.name = in.text();
  order.file = in.text();
  if (in.flag()) order.vertex = shaders::read_compile_request(in);
  order.plain = shaders::read_compile_request(in);
  order.names_places = in.flag();
  order.is_adapter = in.flag();
  if (!in.exhausted()) throw std::logic_error("an order that cannot be read");
  return order;
}

std::string encode(const CompiledModules& made) {
  ByteWriter out;
  for (const auto* module : {&made.vertex, &made.plain, &made.counting}) out.values(*module);
  out.list(made.notes, [&](const std::string& note) { out.text(note); });
  out.list(made.vertex_inputs, [&](const auto& input) {
    out.number(input.first);
    out.text(input.second);
  });
  out.list(made.named_at, [&](const auto& place) {
    out.text(place.first);
    out.text(place.second);
  });
  return out.take();
}

CompiledModules decode_modules(const std::string& bytes) {
  ByteReader in(bytes);
  CompiledModules made;
  for (auto* module : {&made.vertex, &made.plain, &made.counting}) *module = in.values<std::uint32_t>();
  made.notes = in.list<std::string>([&] { return in.text(); });
  for (auto& input : in.list<std::pair<std::uint32_t, std::string>>([&] {
         const auto location = static_cast<std::uint32_t>(in.number());
         return std::pair(location, in.text());
       }))
    made.vertex_inputs.insert(std::move(input));
  for (auto& place : in.list<std::pair<std::string, std::string>>([&] {
         std::string name = in.text();
         return std::pair(std::move(name), in.text());
       }))
    made.named_at.insert(std::move(place));
  if (!in.exhausted()) throw std::invalid_argument("modules that cannot be read");
  return made;
}

std::string encode(const StageTexts& texts) {
  ByteWriter out;
  out.text(texts.vertex);
  out.text(texts.plain);
  return out.take();
}

StageTexts decode_texts(const std::string& bytes) {
  ByteReader in(bytes);
  StageTexts texts;
  texts.vertex = in.text();
  texts.plain = in.text();
  if (!in.exhausted()) throw std::invalid_argument("texts that cannot be read");
  return texts;
}

// SPIRV-Cross and the driver of this process read the modules next and do not check them.
void require_valid(const CompiledModules& made, const ModuleOrder& order) {
  for (const auto* module : {&made.vertex, &made.plain, &made.counting}) {
    if (module == &made.vertex && !order.vertex) continue;
    const std::vector<std::string> problems =
        shaders::validation_problems(*module, shaders::VulkanVersion::v1_1, false);
    if (!problems.empty())
      throw InputError(order.file, "the compiler gave a module that is not valid: " + problems.front());
  }
}

std::string compile_message(const std::string& message, platform::WorkerLink&) {
  return platform::answer_or_input_error([&] {
    ByteReader in(message);
    const Task task = in.enumerator(Task::translate);
    StageTexts bytecode;
    bytecode.vertex = in.text();
    bytecode.plain = in.text();
    const ModuleOrder order = decode_order(in);
    if (task == Task::expand) return encode(expand_here(order));
    return encode(task == Task::compile ? compile_here(order) : translate_here(order, bytecode));
  });
}

std::string asked(const ModuleOrder& order, const Compiler& compiler, const std::string& message) {
  platform::WorkerOutcome outcome = platform::ask_worker(compiler.process, message);
  if (!outcome.failure.empty()) {
    const shaders::CompilerFailure failure = shaders::compiler_failure(outcome);
    throw InputError(order.file, failure.problem, failure.remedy);
  }
  return platform::taken_answer(std::move(outcome.answer));
}

std::string required_bytecode(const shaders::CompileRequest& request, const std::string& text,
                              const BytecodeCompiler& fxc) {
  Bytecode made = fxc(request, text);
  if (made.bytes.empty())
    throw InputError(request.file.string(), "does not compile by FXC:", std::move(made.messages));
  return std::move(made.bytes);
}

std::vector<shaders::Resource> uniforms_of(const std::string& bytecode, const ModuleOrder& order) {
  try {
    return shaders::bytecode_uniforms(bytecode);
  } catch (const std::invalid_argument& problem) {
    throw InputError(order.file, problem.what());
  }
}

// The other process expands the source, FXC compiles it here, and the other process translates the bytecode.
CompiledModules modules_of_bytecode(const ModuleOrder& order, const Compiler& compiler) {
  const bool here = compiler.process.arguments.empty();
  const StageTexts texts =
      here ? expand_here(order) : decode_texts(asked(order, compiler, encode(order, Task::expand)));
  StageTexts bytecode;
  if (order.vertex) bytecode.vertex = required_bytecode(*order.vertex, texts.vertex, compiler.fxc);
  bytecode.plain = required_bytecode(order.plain, texts.plain, compiler.fxc);
  CompiledModules made =
      here ? translate_here(order, bytecode)
           : decode_modules(asked(order, compiler, encode(order, Task::translate, bytecode)));
  if (order.vertex) made.vertex_uniforms = uniforms_of(bytecode.vertex, order);
  made.uniforms = uniforms_of(bytecode.plain, order);
  return made;
}

}  // namespace

CompiledModules compile_modules(const ModuleOrder& order, const Compiler& compiler) {
  const bool here = compiler.process.arguments.empty();
  if (here && !compiler.fxc) return compile_here(order);
  CompiledModules made = compiler.fxc ? modules_of_bytecode(order, compiler)
                                      : decode_modules(asked(order, compiler, encode(order, Task::compile)));
  if (!here) require_valid(made, order);
  return made;
}

int serve_modules() {
  return platform::serve_worker(compile_message);
}

}  // namespace penumbra::resolve
