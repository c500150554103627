// The messages to and from a unit's worker.
//
// Units of one run share answers. Once the text is there, the worker asks whether another unit has the same
// text, and once the module is there, whether another has the same module. The run, which knows all units at
// work, answers "mine" to the first alone; the others leave the answer to it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "validation/kept_answers.h"
#include "validation/unit.h"

namespace penumbra::validation {

struct UnitJob {
  CompileUnit unit;
  AnswerContext context;
  std::vector<std::string> given_up;      // targets in which it has crashed or hung before
  Sharing sharing = Sharing::everything;  // shared with what this worker has compiled before
  // The reply then has only the text that the parser would read, for a file that reproduces a crash.
  bool text_only = false;
  bool wants_emitted = false;  // the reply then has UnitReply::emitted_texts
};

struct EntryToKeep {
  EntryKind kind = EntryKind::sources;
  std::string key;
  std::string content;
};

struct UnitReply {
  std::string text_key;                  // empty when there is no text; then `compile` says why
  std::optional<CompileAnswer> compile;  // empty when another unit with this text has it
  std::optional<EmittedAnswer> emitted;  // empty without a module, or when another unit with it has it
  std::vector<std::filesystem::path> dependencies;
  bool compile_cached = false;
  bool emitted_cached = false;
  std::string text;  // set if text_only was requested
  // Each target with the text that was emitted for it, or with the bytes of its SPIR-V.
  std::vector<std::pair<std::string, std::string>> emitted_texts;
  std::uint64_t damaged = 0;         // cache entries that were met
  std::vector<EntryToKeep> to_keep;  // entries for the cache: a worker changes no file
};

std::string encode(const UnitJob& job);
std::string encode(const UnitReply& reply);
std::optional<UnitJob> decode_job(std::string_view bytes);
std::optional<UnitReply> decode_reply(std::string_view bytes);

// A question is one of these letters and a key; the answer is one of these words.
inline constexpr char question_text = 't';
inline constexpr char question_module = 'm';
inline constexpr std::string_view answer_mine = "mine";
inline constexpr std::string_view answer_known = "known";

// These notes are set while the text is made, while it is compiled, and while it is linted; after that, each
// target's name is.
inline constexpr std::string_view note_text = "text";
inline constexpr std::string_view note_compile = "spirv";
inline constexpr std::string_view note_lint = "lint";

}  // namespace penumbra::validation
