// Evaluates the condition of an #if, with the macros known so far. Internal to this folder.
//
// The rules are C's (ISO C 6.10.1): integers, defined, ! ~ - + * / % << >> comparisons == != & ^ | && || ?:
// and parentheses; an identifier that is not a macro is 0. The use of a macro whose replacement list has # or
// ##, or with a wrong number of arguments, counts as 0 and is reported as the problem. Arithmetic wraps at 64
// bits. Nesting is bounded, and so is the work: `budget` is the remaining number of tokens for all conditions
// of one program.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace penumbra::variants {

struct Macro {
  std::string replacement;
  bool has_parameters = false;
};
using Macros = std::map<std::string, Macro, std::less<>>;

struct Condition {
  bool holds = false;
  std::string problem;              // empty if the whole condition was evaluated
  std::set<std::string> consulted;  // every identifier that was looked up, defined or not
};

Condition evaluate(std::string_view condition, const Macros& macros, std::size_t& budget);

}  // namespace penumbra::variants
