// A unit of validation and its result: the messages to and from workers, and the cache entries.
//
// The encoded forms are specific to this build: both ends are the same program, and the cache's keys contain
// the identity of the build. Decoding rejects truncated and damaged data.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hlsl/diagnostic.h"
#include "platform/content_hash.h"
#include "shaders/compile.h"
#include "validation/report.h"

namespace penumbra::validation {

// The lint options of a unit (lint/module_rules.h).
struct LintOrder {
  bool wanted = false;
  int shader_target = 0;              // ten times `#pragma target`; 0 if none was given
  std::vector<std::string> left_out;  // rules
};

// An entry point of one file with one keyword set. Everything except the request, the targets and the lint
// options is for the report only: results do not depend on it.
struct CompileUnit {
  std::string technique;
  std::string file;
  std::string shader;
  std::string pass;
  int sub_shader = 0;  // number in a .shader, from 0
  std::vector<std::string> keywords;
  shaders::CompileRequest compile;
  std::vector<std::string> targets;  // "spirv" and names of shaders::Target
  LintOrder lint;
  // It is equal for the stages of one program, which are compared (stage_linkage.h); -1 means no program. It
  // is not sent to workers.
  int program = -1;
  bool stage_keywords = true;  // see variants::keeps_stage_keywords(); not sent either
};

// Adds everything that distinguishes the unit from others of its file: technique, shader, pass, entry point,
// stage, keywords.
void add_names(platform::ContentHash& hash, const CompileUnit& unit);
// Adds the same for all stages of a variant: without entry point and stage.
void add_variant_names(platform::ContentHash& hash, const CompileUnit& unit);

struct TargetResult {
  VariantStatus status = VariantStatus::passed;  // passed, failed, unreached or unchecked
  std::vector<hlsl::Diagnostic> diagnostics;
  std::string reproduction;  // a file with the text that crashed or hung a compiler; else empty
};

struct UnitResult {
  std::size_t unit = 0;               // its place among the units of the run
  std::vector<TargetResult> targets;  // results in the order of CompileUnit::targets
  std::string text_key;    // equal for units with the same text for the parser; empty if there is no text
  std::string module_key;  // key of the SPIR-V; empty when there is none
  std::string unchecked;   // why every target is unchecked; else empty
  std::vector<std::filesystem::path> dependencies;  // every file that was read
  bool cached = false;                              // the answer is of an earlier run
  // The unit's constant buffers, as decode_buffers() takes them; null when it was not linted.
  std::shared_ptr<const std::string> buffers;
  std::shared_ptr<const std::string> signature;  // for decode_signature(); null when there is no module
};

// The result of compiling one text, up to valid SPIR-V.
struct CompileAnswer {
  std::vector<hlsl::Diagnostic> diagnostics;
  std::vector<shaders::TargetDiagnostics> of_targets;
  std::string module_key;  // empty when there is no SPIR-V
  std::string unchecked;   // see UnitResult
  // The files that the messages quote, and those whose comments or conditions lint reads, with the hash of
  // their contents. These are not part of a text key: a cached result is used only if they are the same.
  std::vector<std::pair<std::string, std::string>> quoted;
  std::shared_ptr<const std::string> buffers;    // see UnitResult
  std::shared_ptr<const std::string> signature;  // see UnitResult
};

// The results of one module in every target but "spirv", in the order of CompileUnit::targets.
using EmittedAnswer = std::vector<std::vector<hlsl::Diagnostic>>;

std::string encode(const shaders::CompileRequest& request);
std::string encode(const LintOrder& order);
std::string encode(const CompileUnit& unit);
std::string encode(const std::vector<hlsl::Diagnostic>& diagnostics);
std::string encode(const CompileAnswer& answer);
std::string encode(const EmittedAnswer& answer);
std::string encode(const shaders::Signature& signature);
std::optional<CompileUnit> decode_unit(std::string_view bytes);
std::optional<CompileAnswer> decode_compile_answer(std::string_view bytes);
std::optional<EmittedAnswer> decode_emitted_answer(std::string_view bytes);
std::optional<shaders::Signature> decode_signature(std::string_view bytes);

// The work that the units of a run share; less than `everything` is only for benchmarks.
enum class Sharing {
  nothing,       // every unit is processed on its own
  declarations,  // unreached declarations are checked once (checked_declarations.h)
  everything,    // each text, each reached text and each module is processed once
};

}  // namespace penumbra::validation
