// The argument of --keywords: terms, separated by spaces or commas, that narrow the variants of every
// program.
//
//   +NAME     always on, in programs that declare it
//   -NAME     never on
//   A|B       in sets that contain A or B, only A and B; with '_' among them also the empty keyword: A|_
//
// "+_NORMALMAP -DEBUG_DISPLAY FOG_EXP2|_". A keyword may be repeated if the terms agree.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "variants/clause.h"
#include "variants/pragmas.h"

namespace penumbra::variants {

// Throws InputError with the wrong term and the correct syntax.
std::vector<Clause> parse_keyword_expression(std::string_view expression);

// Returns a message for each keyword of the clauses that no program declares: "no program declares 'X'; did
// you mean 'Y'?". A misspelt exclusion excludes nothing, so this is reported.
std::vector<std::string> unknown_keywords(const std::vector<Clause>& clauses,
                                          const std::vector<const Pragmas*>& programs);

}  // namespace penumbra::variants
