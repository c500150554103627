// What --keywords takes: words, separated by blanks or commas, that narrow the variants of every program.
//
//   +NAME     always on, in programs that declare it
//   -NAME     never on
//   A|B       of the sets that hold A or B, only A and B; with '_' among them the empty keyword, too: A|_
//
// "+_NORMALMAP -DEBUG_DISPLAY FOG_EXP2|_". A keyword may be named again if it says the same.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "variants/clause.h"
#include "variants/pragmas.h"

namespace penumbra::variants {

// Throws InputError: the word that is wrong, and how to write it.
std::vector<Clause> parse_keyword_expression(std::string_view expression);

// A message for each keyword of the clauses that no program declares: "no program declares 'X'; did you mean
// 'Y'?". A misspelt exclusion excludes nothing, so this is worth saying.
std::vector<std::string> unknown_keywords(const std::vector<Clause>& clauses,
                                          const std::vector<const Pragmas*>& programs);

}  // namespace penumbra::variants
