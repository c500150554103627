// From a place in SPIR-V, or a name, to the line and column a person would look at. Internal to this room.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/source_text.h"
#include "lint/rule.h"
#include "spirv/code.h"

namespace penumbra::lint {

// What a rule needs to speak of a module: its instructions and the texts they come from.
struct LintedCode {
  const spirv::Code& code;
  const hlsl::SourceFiles& sources;
  std::string main_file;  // for findings with no place at all
};

// A finding of the rule, with its severity, at the line; the column is that of the first of the words that
// stands in the line exactly once ("uv" of "input.uv" as well), else unknown.
Finding finding_at(const LintedCode& linted, const std::string& rule, spirv::Place place,
                   const std::vector<std::string>& words, std::string message);

// The same at a function's definition: OpLine gives the line of its body's brace, so the lines before are
// searched for its name, and from there for the first word of `words` (a parameter).
Finding finding_at_function(const LintedCode& linted, const std::string& rule, spirv::Place body,
                            const std::string& name, const std::string& word, std::string message);

// The same where a global name is declared: the first line that holds the name and one of the words that
// make it a declaration, outside of // comments. Without such a line the finding is the file's.
Finding finding_at_declaration(const LintedCode& linted, const std::string& rule, const std::string& name,
                               const std::vector<std::string>& declaring, std::string message);

// 1-based column of the word where it stands alone and only once, else 0.
int column_of_word(std::string_view word, std::string_view line);

}  // namespace penumbra::lint
