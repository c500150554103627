// Cached results of earlier runs: their keys, and when they are valid.
//
// Three steps, each with its own key, so that a change invalidates as little as possible:
//   sources   the request -> the text that results from it, while the files it read are unchanged
//   compile   the text and the options of compiling it -> diagnostics and the module
//   emitted   the module, the targets and the drivers -> diagnostics of the targets
// Every key contains the identity of the build: a new program, or a new shared library, invalidates all.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "platform/cache_store.h"
#include "validation/unit.h"

namespace penumbra::validation {

// The kinds of cache entries of validation (platform/cache_store.h).
enum class EntryKind {
  sources,  // the files that a text consists of, and its key (source_record.h)
  compile,  // a CompileAnswer
  emitted,  // an EmittedAnswer
};

inline constexpr std::array<std::string_view, 3> entry_kinds{"sources", "compile", "emitted"};

constexpr std::string_view name_of(EntryKind kind) {
  return entry_kinds[static_cast<std::size_t>(kind)];
}

// The inputs of a result besides the unit, and the cache's folder.
struct AnswerContext {
  std::filesystem::path cache;                 // empty: no cache
  std::string build;                           // platform::build_identity()
  std::map<std::string, std::string> drivers;  // target -> the driver that checks it
};

std::string sources_key(const AnswerContext& context, const CompileUnit& unit);
std::string text_key(const AnswerContext& context, const CompileUnit& unit,
                     const shaders::PreprocessedSource& source);
// Units with the same text and the same emitted targets share one result. Units of one text for different
// targets have different keys: there is a module to emit only where the text was compiled.
std::string shared_key(const CompileUnit& unit, const std::string& text_key);
std::string module_key(const std::vector<std::uint32_t>& spirv);
std::string emitted_key(const AnswerContext& context, const CompileUnit& unit, const std::string& module);

// Returns the hash of a file's current contents (source_hash), or nothing if it cannot be read.
using HashNow = std::function<std::optional<std::string>(const std::string& file)>;

std::optional<CompileAnswer> kept_compile_answer(platform::CacheStore& cache, const std::string& text_key,
                                                 const HashNow& hash_now);
std::optional<EmittedAnswer> kept_emitted_answer(platform::CacheStore& cache, const std::string& key);

bool compiled_by_fxc(const CompileUnit& unit);  // its one target is fxc_target
// FXC is at hand, and Unity would ask it, so that its verdict counts on what glslang refuses.
bool fxc_decides(const AnswerContext& context, const CompileUnit& unit);
bool emits(const CompileUnit& unit);  // has a target that is made from a module

}  // namespace penumbra::validation
