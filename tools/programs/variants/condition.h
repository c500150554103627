// Evaluates the condition of an #if, with the macros known so far. Internal to this room.
//
// C's rules (ISO C 6.10.1): integers, defined, ! ~ - + * / % << >> comparisons == != & ^ | && || ?: and
// parentheses; a name that is no macro is 0. The use of a macro whose replacement has # or ##, or of one with
// another number of arguments, counts as 0 and is said in the problem. Arithmetic wraps at 64 bits. Nesting
// is bounded, and so is the work: `budget` is what is left of it, in tokens, for all conditions of one
// reading.
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
  std::string problem;              // empty when the condition was understood whole
  std::set<std::string> consulted;  // every name asked for, defined or not
};

Condition evaluate(std::string_view condition, const Macros& macros, std::size_t& budget);

}  // namespace penumbra::variants
