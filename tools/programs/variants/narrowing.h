// Everything that narrows the variants of a project.
#pragma once

#include "variants/keyword_set.h"
#include "variants/keyword_space.h"
#include "variants/pragmas.h"
#include "variants/urp_settings.h"

namespace penumbra::variants {

struct NarrowingInput {
  std::filesystem::path stripping;                // read_stripping(); empty: none
  std::vector<std::filesystem::path> urp_assets;  // urp_settings.h
  std::vector<std::string> keywords;              // parse_keyword_expression()
};

// Combines all of them; each may only remove variants. Throws InputError.
Narrowing read_narrowing(const NarrowingInput& input);

// The keywords and settings that a project uses, so that only those variants are compiled.
//
// A stripping file is JSON; every key is optional:
//   {
//     "keywords":       {"DEBUG_DISPLAY": "never", "_NORMALMAP": "always", "FOG_EXP2": "both"},
//     "urp":            {"main_light_shadows": true, "fog": ["exp2"], ...},      see urp_settings.h
//     "shader_feature": "used",                          or "all": every combination, the default
//     "materials":      [["_NORMALMAP"], ["_NORMALMAP", "_EMISSION"], []]
//   }
// "materials" lists the keywords each material has on (a .mat file's m_ValidKeywords) and means "used"; with
// it the shader_feature sets of a program have one combination for each distinct material: of every set the
// first alternative the material has on, else the empty keyword. "used" without materials keeps the one with
// all off.
//
// "urp" also leaves out the passes that no such project draws (urp_settings.h: unused_passes()). "both" in
// "keywords" overrides what "urp" says about that keyword.
//
// Throw InputError with the location of the error; for unknown keys with the nearest known one.
Narrowing read_stripping(const std::filesystem::path& file);
Narrowing parse_stripping(std::string_view text, const std::string& name);

// The argument of --keywords: terms, separated by spaces or commas, that narrow the variants of every
// program.
//
//   +NAME     always on, in programs that declare it
//   -NAME     never on
//   A|B       in sets that contain A or B, only A and B; with '_' among them also the empty keyword: A|_
//
// "+_NORMALMAP -DEBUG_DISPLAY FOG_EXP2|_". A keyword may be repeated if the terms agree.
//
// Throws InputError with the wrong term and the correct syntax.
std::vector<Clause> parse_keyword_expression(std::string_view expression);

// Returns a message for each keyword of the clauses that no program declares: "no program declares 'X'; did
// you mean 'Y'?". A misspelt exclusion excludes nothing, so this is reported.
std::vector<std::string> unknown_keywords(const std::vector<Clause>& clauses,
                                          const std::vector<const Pragmas*>& programs);

}  // namespace penumbra::variants
