#include "resolve/module_order.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "hlsl/source_text.h"
#include "input/input_error.h"
#include "platform/byte_stream.h"
#include "platform/worker_answer.h"
#include "resolve/frame_on_device.h"
#include "shaders/bytecode_module.h"
#include "shaders/compile_message.h"
#include "shaders/counted_module.h"
#include "shaders/module_uses.h"
#include "shaders/pipeline_interface.h"
#include "shaders/spirv_module.h"

namespace penumbra::resolve {

using platform::ByteReader;
using platform::ByteWriter;

namespace {

// The message for compiler errors about this name.
struct MissingName {
  std::string name;
  std::string remedy;
};

// A vertex shader's module, with the semantics of those inputs that it reads, by location.
struct VertexModule {
  std::vector<std::uint32_t> spirv;
  std::map<std::uint32_t, std::string> inputs;
};

// Returns the way out for what the compiler does not know.
std::string remedy_of(const std::string& messages, const MissingName& needed) {
  if (messages.find("'" + needed.name + "'") != std::string::npos) return needed.remedy;
  for (const char* macro : {"'TEXTURE2D_ARRAY'", "'TEXTURECUBE'", "'TEXTURECUBE_ARRAY'", "'TEXTURE3D'"}) {
    if (messages.find(macro) != std::string::npos) return "only 2D textures are provided: TEXTURE2D";
  }
  return "";
}

void require_success(const shaders::CompileRequest& request, const std::vector<hlsl::Diagnostic>& diagnostics,
                     const MissingName* needed = nullptr) {
  if (!hlsl::has_errors(diagnostics)) return;
  std::string messages;
  for (const hlsl::Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity == hlsl::Severity::error)
      messages += (messages.empty() ? "" : "\n") + hlsl::format(diagnostic);
  }
  const std::string remedy = needed == nullptr ? "" : remedy_of(messages, *needed);
  // The messages are the way out of the error, because only there do lines stay lines.
  throw InputError(request.file.string(),
                   "does not compile:", messages + (remedy.empty() ? "" : "\n  " + remedy));
}

// Returns the module; throws InputError with the compiler's messages. `notes` are formatted messages,
// `sources` the texts that were read, and `unoptimised` as in shaders::CompileResult.
std::vector<std::uint32_t> required_module(const shaders::CompileRequest& request,
                                           std::vector<std::string>* notes = nullptr,
                                           const MissingName* needed = nullptr,
                                           hlsl::SourceFiles* sources = nullptr,
                                           std::vector<std::uint32_t>* unoptimised = nullptr) {
  shaders::CompileResult result = shaders::compile(request);
  if (unoptimised != nullptr) *unoptimised = std::move(result.unoptimised);
  if (sources != nullptr) *sources = result.sources;
  for (const hlsl::Diagnostic& diagnostic : result.diagnostics) {
    if (notes != nullptr && diagnostic.severity == hlsl::Severity::note) {
      notes->push_back(hlsl::format(diagnostic));
    }
  }
  require_success(request, result.diagnostics, needed);
  return std::move(result.spirv);
}

// Returns the text without includes and macros, for another compiler: nothing in it is prepared for glslang.
// Throws as above.
std::string required_text(const shaders::CompileRequest& request, hlsl::SourceFiles* sources = nullptr) {
  shaders::CompileRequest unprepared = request;
  unprepared.prepare = false;
  shaders::PreprocessedSource source = shaders::preprocess(unprepared);
  require_success(request, source.diagnostics);
  if (sources != nullptr) *sources = std::move(source.sources);
  return std::move(source.text);
}

VertexModule vertex_module(std::vector<std::uint32_t> spirv, const shaders::Signature& signature,
                           const std::string& entry) {
  VertexModule module{std::move(spirv), {}};
  for (const shaders::StageLocation& input : shaders::pipeline_interface(module.spirv, entry).inputs) {
    const auto element =
        std::find_if(signature.begin(), signature.end(), [&](const shaders::SignatureElement& declared) {
          return !declared.output && declared.location == static_cast<int>(input.location);
        });
    module.inputs[input.location] = element == signature.end() ? "" : element->semantic;
  }
  return module;
}

VertexModule required_vertex_module(const shaders::CompileRequest& request) {
  shaders::CompileResult result = shaders::compile(request);
  require_success(request, result.diagnostics);
  return vertex_module(std::move(result.spirv), result.signature, request.entry);
}

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Returns the first line of any text that has the name as a word, or 0.
int line_of_name(const std::string& text, const std::string& name) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool whole = (at == 0 || !is_name_character(text[at - 1])) &&
                       (end == text.size() || !is_name_character(text[end]));
    if (whole)
      return static_cast<int>(
                 std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')) +
             1;
  }
  return 0;
}

// Returns the place in the first file that was read and has the name. The user's own file is read before
// those that it includes.
std::string place_of_name(const hlsl::SourceFiles& sources, const std::string& name) {
  for (const std::string& file : sources.names()) {
    const int line = line_of_name(sources.text(file), name);
    if (line != 0) return file + ":" + std::to_string(line);
  }
  return "";
}

// Returns "file:line" of the first file that was read and has the name, for this function and for every
// resource and uniform that the module reads.
std::map<std::string, std::string> named_places(const std::vector<std::uint32_t>& spirv,
                                                const hlsl::SourceFiles& sources,
                                                const std::string& function) {
  std::map<std::string, std::string> places;
  const auto add = [&](const std::string& name) {
    const std::string place = place_of_name(sources, name);
    if (!place.empty()) places[name] = place;
  };
  add(function);
  for (const shaders::Resource& resource : shaders::reflect(spirv).resources) {
    add(resource.name);
    for (const shaders::UniformMember& member : resource.members) {
      if (member.read) add(member.name);
    }
  }
  return places;
}

using shaders::SpirvModule;

std::string text_of(const shaders::SourcePlace& place, const std::string& shader) {
  return place.line == 0 ? shader : place.file + ":" + std::to_string(place.line);
}

bool compares(const std::string& sampler) {
  // Samplers of the user's textures do not compare.
  return FrameOnDevice::sampler_compares(sampler).value_or(false);
}

// The shader may declare a sampler as another kind than the one its name stands for.
void refuse_misused_samplers(const SpirvModule& module, const std::string& shader) {
  for (const shaders::SamplerUse& use : shaders::sampler_uses(module)) {
    if (use.compares == compares(use.sampler)) continue;
    if (use.compares) {
      throw InputError(text_of(use.place, shader),
                       "compares through '" + use.sampler + "', which is not a comparison sampler",
                       "use sampler_LinearClampCompare, or read without comparing");
    }
    throw InputError(text_of(use.place, shader),
                     "reads without comparing through '" + use.sampler + "', which is a comparison sampler",
                     "use sampler_LinearClamp or SAMPLE_TEXTURE2D_SHADOW");
  }
}

// A pixel that is discarded writes no result, so what is read there is whatever the memory held.
void refuse_discard(const SpirvModule& module, const std::string& shader) {
  const std::optional<shaders::SourcePlace> place = shaders::first_discard(module);
  if (!place) return;
  throw InputError(text_of(*place, shader), "discards the pixel, so there is no visibility to measure there",
                   "return 1.0 (lit) or 0.0 (in shadow) instead of 'discard' and 'clip'");
}

// HLSL would take the first of several numbers without a message.
void refuse_several_numbers(const SpirvModule& unoptimised, const std::string& where) {
  if (!shaders::returns_several_numbers(unoptimised, "ShadowVisibility")) return;
  throw InputError(where, "ShadowVisibility returns more than one number",
                   "it returns a float, the visibility: 1 = lit, 0 = in shadow");
}

std::string place_of(const std::map<std::string, std::string>& places, const std::string& name,
                     const std::string& shader) {
  const auto found = places.find(name);
  return found == places.end() ? shader : found->second;
}

void refuse_other_textures(const SpirvModule& module, const std::map<std::string, std::string>& places,
                           const std::string& shader) {
  for (const std::string& texture : shaders::textures_that_are_not_2d(module)) {
    throw InputError(place_of(places, texture, shader), "'" + texture + "' is not a plain 2D texture",
                     "only 2D textures are provided: TEXTURE2D");
  }
}

// `unoptimised` is the function's module before optimisation, with debug lines; `places` is
// CompiledShadowShader::named_at. Throws InputError, naming the line or else the shader, for
// - a comparison through a sampler that does not compare, and other reads through one that does;
// - `discard` and `clip`;
// - textures other than plain 2D ones;
// - a ShadowVisibility that returns more than one number.
void check_adapter(std::vector<std::uint32_t> unoptimised, const std::string& shader,
                   const std::map<std::string, std::string>& places) {
  refuse_several_numbers(unoptimised, place_of(places, "ShadowVisibility", shader));
  SpirvModule module = std::move(unoptimised);
  std::vector<std::string> problems;
  // The checks apply to the module that ships.
  if (!shaders::optimise(module, shaders::VulkanVersion::v1_1, problems)) return;
  refuse_misused_samplers(module, shader);
  refuse_discard(module, shader);
  refuse_other_textures(module, places, shader);
}

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
