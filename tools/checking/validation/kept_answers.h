// Answers of earlier runs: under which keys they are kept, and when they still hold.
//
// Three steps, each with its own key, so that a change costs no more than it must:
//   sources   the request as it is written -> which text it makes, while the files it read are unchanged
//   compile   the text and the options of compiling it -> messages and the module
//   emitted   the module, the targets and the drivers -> messages of the targets
// Every key holds the identity of the build: a new program, or a new library under it, starts anew.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "validation/entry_kind.h"
#include "validation/unit.h"

namespace penumbra::validation {

// Everything beside the unit that an answer depends on, and where answers are kept.
struct AnswerContext {
  std::filesystem::path cache;                 // empty keeps nothing
  std::string build;                           // platform::build_identity()
  std::map<std::string, std::string> drivers;  // target -> the driver that checks it
};

std::string sources_key(const AnswerContext& context, const CompileUnit& unit);
std::string text_key(const AnswerContext& context, const CompileUnit& unit,
                     const shaders::PreprocessedSource& source);
// One unit answers for all that share its text and what is emitted from it. Units of one text for different
// targets each have their own: there is a module to emit only where the text was compiled.
std::string shared_key(const CompileUnit& unit, const std::string& text_key);
std::string module_key(const std::vector<std::uint32_t>& spirv);
std::string emitted_key(const AnswerContext& context, const CompileUnit& unit, const std::string& module);

// The hash of what a file holds now (source_hash); nothing when it cannot be read.
using HashNow = std::function<std::optional<std::string>(const std::string& file)>;

std::optional<CompileAnswer> kept_compile_answer(platform::CacheStore& cache, const std::string& text_key,
                                                 const HashNow& hash_now);
std::optional<EmittedAnswer> kept_emitted_answer(platform::CacheStore& cache, const std::string& key);

bool emits(const CompileUnit& unit);  // has a target other than "spirv"

}  // namespace penumbra::validation
