// Maps a location in SPIR-V, or a name, to a source line and column. Internal to this folder.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/source_text.h"
#include "spirv/code.h"

namespace penumbra::lint {

// A module's instructions and the texts from which they come.
struct LintedCode {
  const spirv::Code& code;
  const hlsl::SourceFiles& sources;
  std::string main_file;  // the file of findings that have no place at all
};

// Returns a finding of the rule, with its severity, at the line; the column is that of the first of the names
// that occurs in the line exactly once ("uv" of "input.uv" as well), else unknown.
hlsl::Diagnostic finding_at(const LintedCode& linted, const std::string& rule, spirv::Place place,
                            const std::vector<std::string>& words, std::string message);

// Returns the same where a global name is declared: the first line that contains the name and a keyword that
// makes it a declaration, outside of // comments. Without such a line, the finding is for the whole file.
hlsl::Diagnostic finding_at_declaration(const LintedCode& linted, const std::string& rule,
                                        const std::string& name, const std::vector<std::string>& declaring,
                                        std::string message);

// Returns the place for messages that are at `from`: " at line 12", " at Other.hlsl:12"; empty if it has no
// line.
std::string place_in_words(const LintedCode& linted, spirv::Place place, spirv::Place from);

}  // namespace penumbra::lint
