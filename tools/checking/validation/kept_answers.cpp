#include "validation/kept_answers.h"

#include <algorithm>
#include <span>

#include "platform/content_hash.h"
#include "shaders/fxc_program.h"
#include "validation/spirv_target.h"

namespace penumbra::validation {
namespace {

platform::ContentHash keyed(const char* purpose, const AnswerContext& context) {
  platform::ContentHash hash;
  hash.update(purpose).update(context.build);
  return hash;
}

// FXC judges the texts that glslang compiles, too, so the key of an answer names its compilers.
std::string compiler_of(const AnswerContext& context, const CompileUnit& unit) {
  const bool alone = compiled_by_fxc(unit);
  if (!alone && !fxc_decides(context, unit)) return {};
  return (alone ? "FXC" : "glslang, FXC") + context.drivers.at(std::string(fxc_target)) +
         shaders::fxc_profile(unit.compile);
}

}  // namespace

std::string sources_key(const AnswerContext& context, const CompileUnit& unit) {
  return keyed("sources", context)
      .update(encode(unit.compile))
      .update(encode(unit.lint))
      .update(compiler_of(context, unit))
      .hex();
}

// The text already accounts for the inputs of the preprocessor; all others may affect the compiler.
std::string text_key(const AnswerContext& context, const CompileUnit& unit,
                     const shaders::PreprocessedSource& source) {
  shaders::CompileRequest rest = unit.compile;
  rest.text.reset();
  rest.written_for.reset();
  rest.defines.clear();
  rest.package_roots.clear();
  rest.include_directories.clear();
  rest.project.clear();
  rest.cginc_root.clear();
  return keyed("text", context)
      .update(encode(rest))
      .update(encode(unit.lint))
      .update(source.text)
      .update(encode(source.diagnostics))
      .update(compiler_of(context, unit))
      .hex();
}

std::string shared_key(const CompileUnit& unit, const std::string& text_key) {
  std::string key = text_key;
  for (const std::string& target : unit.targets)
    if (!is_compiled_target(target)) key.append(" ").append(target);
  return key;
}

std::string module_key(const std::vector<std::uint32_t>& spirv) {
  return platform::ContentHash().update(std::span<const std::uint32_t>(spirv)).hex();
}

std::string emitted_key(const AnswerContext& context, const CompileUnit& unit, const std::string& module) {
  platform::ContentHash hash = keyed("emitted", context);
  hash.update(module).update(static_cast<int>(unit.compile.stage));
  for (const std::string& target : unit.targets) {
    if (is_compiled_target(target)) continue;
    const auto driver = context.drivers.find(target);
    hash.update(target).update(driver == context.drivers.end() ? "" : driver->second);
  }
  return hash.hex();
}

std::optional<CompileAnswer> kept_compile_answer(platform::CacheStore& cache, const std::string& text_key,
                                                 const HashNow& hash_now) {
  const std::optional<std::string> entry = cache.find(name_of(EntryKind::compile), text_key);
  if (!entry) return std::nullopt;
  std::optional<CompileAnswer> answer = decode_compile_answer(*entry);
  if (!answer) return std::nullopt;
  const bool holds = std::all_of(answer->quoted.begin(), answer->quoted.end(),
                                 [&](const auto& quoted) { return hash_now(quoted.first) == quoted.second; });
  return holds ? answer : std::nullopt;
}

std::optional<EmittedAnswer> kept_emitted_answer(platform::CacheStore& cache, const std::string& key) {
  const std::optional<std::string> entry = cache.find(name_of(EntryKind::emitted), key);
  return entry ? decode_emitted_answer(*entry) : std::nullopt;
}

bool compiled_by_fxc(const CompileUnit& unit) {
  return unit.targets.size() == 1 && unit.targets.front() == fxc_target;
}

bool fxc_decides(const AnswerContext& context, const CompileUnit& unit) {
  return !compiled_by_fxc(unit) && !unit.compile.dxc && context.drivers.contains(std::string(fxc_target));
}

bool emits(const CompileUnit& unit) {
  return std::any_of(unit.targets.begin(), unit.targets.end(),
                     [](const std::string& target) { return !is_compiled_target(target); });
}

}  // namespace penumbra::validation
